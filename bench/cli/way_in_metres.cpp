#include "bench/cli/way_in_metres.hpp"

#include <fmt/format.h>

#include <cmath>

#include "bench/cli/or_dash.hpp"

namespace pathrace::bench::cli {
namespace {

results::PlaceInMetres metres_of(const scenarios::MapFrame& frame, Point point) {
  const scenarios::WorldPoint place = frame.place_of(point);
  return {place.x, place.y};
}

std::string place_text(results::PlaceInMetres place) {
  return fmt::format("{:.3f},{:.3f}", place.x, place.y);
}

// Where the way turns, start and goal included.
std::vector<results::PlaceInMetres> turning_points(const std::vector<results::PlaceInMetres>& points) {
  std::vector<results::PlaceInMetres> turning;
  for (const results::PlaceInMetres point : points) {
    const std::size_t n = turning.size();
    if (n >= 2) {
      const auto [ax, ay] = turning[n - 2];
      const auto [bx, by] = turning[n - 1];
      const double cross = (bx - ax) * (point.y - by) - (by - ay) * (point.x - bx);
      const double along = (bx - ax) * (point.x - bx) + (by - ay) * (point.y - by);
      if (along > 0 && std::fabs(cross) <= 1e-9 * along) turning.pop_back();
    }
    turning.push_back(point);
  }
  return turning;
}

}  // namespace

results::InMetres in_metres(const scenarios::MapFrame& frame, const Scenario& scenario,
                            const results::TrialRow& row) {
  results::InMetres metres;
  metres.start = metres_of(frame, centre(scenario.start));
  metres.goal = metres_of(frame, centre(scenario.goal));
  if (row.length) metres.length = frame.metres(*row.length);
  if (row.optimum) metres.optimum = frame.metres(*row.optimum);
  if (row.clearance_min) metres.clearance_min = frame.metres(*row.clearance_min);
  if (row.answer) {
    metres.points.emplace();
    for (const Point point : row.answer->points) metres.points->push_back(metres_of(frame, point));
  }
  return metres;
}

void print_way_in_metres(const results::TrialRow& row, const results::InMetres& metres) {
  fmt::print("length       {} m ({} cells)   optimum {} m   gap {}\n", or_dash(metres.length, "{:.4f}"),
             or_dash(row.length, "{:.4f}"), or_dash(metres.optimum, "{:.4f}"), percent_or_dash(row.gap));
  fmt::print("turns        {}   least clearance {} m\n", row.turns ? std::to_string(*row.turns) : "-",
             or_dash(metres.clearance_min, "{:.3f}"));
  fmt::print("start        {} m\ngoal         {} m\n", place_text(metres.start), place_text(metres.goal));
  if (!metres.points) return;
  fmt::print("way, m      ");
  for (const results::PlaceInMetres place : turning_points(*metres.points))
    fmt::print(" {}", place_text(place));
  fmt::print("\n");
}

}  // namespace pathrace::bench::cli
