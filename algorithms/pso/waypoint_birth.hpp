// How a swarm of way-point paths is born: where its particles are and how they move at first.
#pragma once

#include <array>
#include <string_view>
#include <utility>

#include "algorithms/pso/swarm.hpp"
#include "core/cell.hpp"
#include "core/grid.hpp"
#include "core/names.hpp"

namespace pathrace::algorithms {

enum class Birth {
  line,     ///< each way-point near its place on the straight line from start to goal
  uniform,  ///< anywhere on the map
};

class WaypointNursery {
 public:
  /// `scatter`: how far a way-point may be from its place on the line, per coordinate, in cells.
  WaypointNursery(const OccupancyGrid& grid, Cell start, Cell goal, Birth birth, double scatter);

  /// The box of particles with this many way-points; `v_max` counts in half ranges.
  SwarmBox box(std::size_t waypoints, double v_max) const;
  /// Fills in position and velocity of particle i; velocities are uniform within their bounds.
  void place(Swarm& swarm, std::size_t i, Stream stream) const;

 private:
  double birthplace(double from, double to, double share, double high, Stream& stream) const;

  double right_;   // greatest x of a way-point
  double bottom_;  // greatest y
  Point start_;
  Point goal_;
  Birth birth_;
  double scatter_;
};

}  // namespace pathrace::algorithms

namespace pathrace {
template <>
inline constexpr auto names_of<algorithms::Birth> =
    std::to_array<std::pair<algorithms::Birth, std::string_view>>({
        {algorithms::Birth::line, "line"},
        {algorithms::Birth::uniform, "uniform"},
    });
}  // namespace pathrace
