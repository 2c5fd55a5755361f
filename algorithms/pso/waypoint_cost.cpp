#include "algorithms/pso/waypoint_cost.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#ifdef __AVX__
#include <immintrin.h>
#endif

namespace pathrace::algorithms {
namespace {

constexpr std::size_t abreast = WaypointCost::abreast;
using Points = RowChanges::Points;
using Lengths = std::array<double, abreast>;

// Truncation rounds to the nearest: ticks are positive. std::lround would keep loops from becoming vectors.
std::int32_t nearest_tick(double coordinate) {
  const double ticks = (coordinate + 1.5) * ticks_per_cell + 0.5;
  return static_cast<std::int32_t>(ticks);
}

// The k-th points of all paths, from the start to the goal.
struct Polylines {
  std::array<Points, WaypointCost::max_waypoints + 2> points;
  std::size_t segments;
};

void stand(Points& points, Cell cell) {
  points.x.fill(tick_of(cell).x);
  points.y.fill(tick_of(cell).y);
}

// Lanes that are left over repeat the last particle.
void lay_abreast(std::span<const double> coordinates, std::size_t count, Cell start, Cell goal,
                 Polylines& lines) {
  const std::size_t dimensions = coordinates.size() / count;
  const std::size_t waypoints = dimensions / 2;
  lines.segments = waypoints + 1;
  stand(lines.points[0], start);
  stand(lines.points[waypoints + 1], goal);
  for (std::size_t i = 0; i < abreast; ++i) {
    const double* const x = coordinates.data() + std::min(i, count - 1) * dimensions;
    const double* const y = x + waypoints;
    for (std::size_t k = 0; k < waypoints; ++k) lines.points[k + 1].x[i] = nearest_tick(x[k]);
    for (std::size_t k = 0; k < waypoints; ++k) lines.points[k + 1].y[i] = nearest_tick(y[k]);
  }
}

// Square roots are correctly rounded, whatever computes them; std::sqrt keeps loops from becoming vectors.
void take_roots(Lengths& values) {
#ifdef __AVX__
  constexpr std::size_t width = 4;
  for (std::size_t i = 0; i < abreast; i += width) {
    _mm256_storeu_pd(&values[i], _mm256_sqrt_pd(_mm256_loadu_pd(&values[i])));
  }
#else
  for (double& value : values) value = std::sqrt(value);
#endif
}

// Adds the distances, segment by segment.
void measure(const Points& from, const Points& to, Lengths& sums) {
  Lengths distances;
  for (std::size_t i = 0; i < abreast; ++i) {
    const auto dx = static_cast<double>(to.x[i] - from.x[i]);
    const auto dy = static_cast<double>(to.y[i] - from.y[i]);
    distances[i] = dx * dx + dy * dy;
  }
  take_roots(distances);
  for (std::size_t i = 0; i < abreast; ++i) sums[i] += distances[i];
}

}  // namespace

void WaypointCost::judge(std::span<const double> coordinates, std::span<WaypointVerdict> verdicts) const {
  Polylines lines;
  lay_abreast(coordinates, verdicts.size(), start_, goal_, lines);
  Lengths lengths{};
  RowChanges::Sums met;
  for (std::size_t k = 0; k < lines.segments; ++k) {
    measure(lines.points[k], lines.points[k + 1], lengths);
    walls_.cross(lines.points[k], lines.points[k + 1], verdicts.size(), met);
  }
  for (std::size_t i = 0; i < verdicts.size(); ++i) {
    verdicts[i] = {lengths[i] / ticks_per_cell, met.walls[i], met.cells[i]};
  }
}

Path WaypointCost::path(std::span<const double> coordinates) const {
  const std::size_t waypoints = coordinates.size() / 2;
  Path path{Track::any_angle, {centre(start_)}};
  const auto go_on = [&](Point point) {
    if (path.points.back() != point) path.points.push_back(point);
  };
  for (std::size_t k = 0; k < waypoints; ++k) {
    go_on(point_of({nearest_tick(coordinates[k]), nearest_tick(coordinates[waypoints + k])}));
  }
  go_on(centre(goal_));
  return path;
}

}  // namespace pathrace::algorithms
