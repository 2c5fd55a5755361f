// Exact Euclidean distance transform of a grid.
//
// A. Meijster, J. Roerdink, W. Hesselink, "A general algorithm for computing distance transforms in
// linear time", 2000: one pass down and up each column, then the lower envelope of parabolas along
// each row; integers throughout, so the squared distances are exact.
#pragma once

#include <cstdint>
#include <vector>

#include "core/cell.hpp"
#include "core/grid.hpp"

namespace pathrace {

/// Whether the cells outside the map count as blocked.
enum class Border { blocked, open };

class DistanceTransform {
 public:
  explicit DistanceTransform(const OccupancyGrid& grid, Border border = Border::blocked);

  /// More than any squared distance on a map; what every cell has on a map of free cells with an open border.
  static constexpr std::int64_t far = std::int64_t{1} << 40;

  /// Squared distance, in cells, from a cell's centre to the nearest blocked cell's centre; `far`
  /// when there is none. 0 for a blocked cell.
  std::int64_t squared(Cell cell) const {
    const std::uint32_t stored =
        squared_[static_cast<std::size_t>(cell.y) * width_ + static_cast<std::size_t>(cell.x)];
    return stored == beyond ? far : std::int64_t{stored};
  }
  double distance(Cell cell) const;

  int width() const { return static_cast<int>(width_); }
  int height() const { return static_cast<int>(squared_.size() / width_); }

 private:
  static constexpr std::uint32_t beyond = 0xFFFFFFFF;  // stands for `far`

  std::size_t width_;
  std::vector<std::uint32_t> squared_;  // below 2^30 on a map of 16,384 cells a side
};

}  // namespace pathrace
