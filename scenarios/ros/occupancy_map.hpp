// Occupancy as ROS knows it: a probability per cell in percent, or unknown.
//
// From the brightness s of a pixel, 0 black to 1 white: how occupied the cell is, p = 1 - s, or s when
// negated.
//   trinary  100 above occupied_thresh, 0 below free_thresh, else unknown. Where alpha is below the colours,
//            s is the mean of the three colours and alpha: a transparent pixel counts as darker.
//   scale    unknown where not opaque; 100 and 0 as above, and between the thresholds from 0 to 100 in
//            proportion, rounded.
//   raw      255 s, rounded, when that is at most 100, else unknown; negate and alpha count for nothing.
// A p equal to a threshold lies between the two.
//
// map_server of ROS (http://wiki.ros.org/map_server) and nav2_map_server up to Jazzy; where they differ (the
// rounding in scale, raw) as nav2_map_server does. In trinary mode both take the mean with any alpha, so that
// an opaque 205 of a grey picture, unknown, turns free when the same picture is saved with alpha; here an
// opaque picture means the same with and without alpha.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include "core/grid.hpp"
#include "core/names.hpp"
#include "scenarios/image/grey_image.hpp"
#include "scenarios/ros/map_frame.hpp"

namespace pathrace::scenarios {

enum class OccupancyMode { trinary, scale, raw };

/// How to read a picture; the defaults are those of map_server's own files.
struct OccupancyRule {
  OccupancyMode mode = OccupancyMode::trinary;
  bool negate = false;
  double occupied_thresh = 0.65;  ///< 0..1
  double free_thresh = 0.196;     ///< 0..occupied_thresh
};

/// What a robot makes of unknown cells.
enum class UnknownPolicy {
  free,
  blocked,
  threshold,  ///< blocked when the cell is as likely occupied as not, p >= 0.5, or when p is not known
};

class OccupancyMap {
 public:
  static constexpr int unknown = -1;
  /// From this occupancy on a known cell is blocked: in `scale` and `raw` modes as likely occupied as not.
  static constexpr int blocked_from = 50;

  /// `frame` has the size of the image.
  OccupancyMap(const GreyImage& image, const OccupancyRule& rule, const MapFrame& frame);

  int width() const { return frame_.width; }
  int height() const { return frame_.height; }
  const MapFrame& frame() const { return frame_; }
  /// 0..100, or unknown. Expects a cell of the map.
  int occupancy(Cell cell) const { return occupancy_[index(cell)]; }
  std::int64_t unknown_cells() const;

  /// Known cells are blocked from `blocked_from` on, unknown ones by the policy.
  OccupancyGrid grid(UnknownPolicy policy) const;

 private:
  std::size_t index(Cell cell) const {
    return static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(frame_.width) +
           static_cast<std::size_t>(cell.x);
  }

  MapFrame frame_;
  std::vector<std::int8_t> occupancy_;
  std::vector<bool> likely_;  // of an unknown cell: blocked by the threshold policy
};

}  // namespace pathrace::scenarios

namespace pathrace {

template <>
inline constexpr auto names_of<scenarios::OccupancyMode> =
    std::to_array<std::pair<scenarios::OccupancyMode, std::string_view>>(
        {{scenarios::OccupancyMode::trinary, "trinary"},
         {scenarios::OccupancyMode::scale, "scale"},
         {scenarios::OccupancyMode::raw, "raw"}});

template <>
inline constexpr auto names_of<scenarios::UnknownPolicy> =
    std::to_array<std::pair<scenarios::UnknownPolicy, std::string_view>>(
        {{scenarios::UnknownPolicy::free, "free"},
         {scenarios::UnknownPolicy::blocked, "blocked"},
         {scenarios::UnknownPolicy::threshold, "threshold"}});

}  // namespace pathrace
