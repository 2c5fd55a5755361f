#include "algorithms/pso/waypoint_cost.hpp"

#include <array>
#include <cmath>

namespace pathrace::algorithms {
namespace {

// Start, way-points and goal in ticks.
struct Polyline {
  std::array<std::int32_t, WaypointCost::max_waypoints + 2> x;
  std::array<std::int32_t, WaypointCost::max_waypoints + 2> y;
  std::size_t size;
};

// Truncation rounds to the nearest: ticks are positive. std::lround would keep the loop from becoming
// vectors.
std::int32_t nearest_tick(double coordinate) {
  const double ticks = (coordinate + 1.5) * ticks_per_cell + 0.5;
  return static_cast<std::int32_t>(ticks);
}

Polyline polyline(std::span<const double> coordinates, Cell start, Cell goal) {
  const std::size_t count = coordinates.size() / 2;
  Polyline line;
  line.size = count + 2;
  for (std::size_t k = 0; k < count; ++k) line.x[k + 1] = nearest_tick(coordinates[k]);
  for (std::size_t k = 0; k < count; ++k) line.y[k + 1] = nearest_tick(coordinates[count + k]);
  const Tick first = tick_of(start);
  const Tick last = tick_of(goal);
  line.x[0] = first.x;
  line.y[0] = first.y;
  line.x[count + 1] = last.x;
  line.y[count + 1] = last.y;
  return line;
}

}  // namespace

WaypointVerdict WaypointCost::judge(std::span<const double> coordinates) const {
  const Polyline line = polyline(coordinates, start_, goal_);
  std::array<double, max_waypoints + 1> lengths;
  for (std::size_t k = 0; k + 1 < line.size; ++k) {
    const auto dx = static_cast<double>(line.x[k + 1] - line.x[k]);
    const auto dy = static_cast<double>(line.y[k + 1] - line.y[k]);
    lengths[k] = std::sqrt(dx * dx + dy * dy);
  }
  WaypointVerdict verdict;
  for (std::size_t k = 0; k + 1 < line.size; ++k) {
    const Crossing crossing = walls_.cross({line.x[k], line.y[k]}, {line.x[k + 1], line.y[k + 1]});
    verdict.length += lengths[k];
    verdict.walls += crossing.walls;
    verdict.cells += crossing.cells;
  }
  verdict.length /= ticks_per_cell;
  return verdict;
}

Path WaypointCost::path(std::span<const double> coordinates) const {
  const Polyline line = polyline(coordinates, start_, goal_);
  Path path{Track::any_angle, {}};
  for (std::size_t k = 0; k < line.size; ++k) {
    const Point point = point_of({line.x[k], line.y[k]});
    if (path.points.empty() || path.points.back() != point) path.points.push_back(point);
  }
  return path;
}

}  // namespace pathrace::algorithms
