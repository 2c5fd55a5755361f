// The cost of a particle that stands for a path: way-points between start and goal, joined by segments.
//
//   cost = length + penalty * walls
//
// where `walls` counts, over all segments, the blocked cells entered (and what else the any-angle rule
// forbids, see wall_map.hpp). A particle of W way-points has 2 W coordinates in cell edges: x_1..x_W, then
// y_1..y_W. The path that is judged, and answered with, has its way-points rounded to ticks.
//
// Particles are judged abreast, the k-th segments of all of them at once.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "algorithms/pso/wall_map.hpp"
#include "core/path.hpp"

namespace pathrace::algorithms {

struct WaypointVerdict {
  double length = 0;        ///< in cell edges
  std::uint32_t walls = 0;  ///< 0: a legal path
  std::uint32_t cells = 0;  ///< cells tested
};

class WaypointCost {
 public:
  static constexpr std::size_t max_waypoints = 62;
  static constexpr std::size_t abreast = RowChanges::lanes;

  /// The walls outlive the cost.
  WaypointCost(const WallMap& walls, Cell start, Cell goal) : walls_(walls), start_(start), goal_(goal) {}

  /// Of 1..abreast particles, as many as there are verdicts, whose coordinates follow each other, all of one
  /// length. Way-points inside the map.
  void judge(std::span<const double> coordinates, std::span<WaypointVerdict> verdicts) const;
  /// The path that was judged, without points that repeat the one before.
  Path path(std::span<const double> coordinates) const;

 private:
  const WallMap& walls_;
  Cell start_;
  Cell goal_;
};

}  // namespace pathrace::algorithms
