// One trial as a JSON object, for scripts.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/scenario.hpp"
#include "results/row.hpp"

namespace pathrace::results {

/// A place in a map's frame.
struct PlaceInMetres {
  double x = 0;
  double y = 0;
};

/// A question and its answer in the frame of the map, in metres.
struct InMetres {
  std::optional<double> length;
  std::optional<double> optimum;
  std::optional<double> clearance_min;
  PlaceInMetres start;  ///< the centre of the start cell
  PlaceInMetres goal;
  std::optional<std::vector<PlaceInMetres>> points;  ///< one for each point of the path
};

/// Keys in this order: scenario, planner, verdict, track, rule, length, optimum, gap, turns, `cells`
/// (lattice) or `points` (any_angle) as [[x,y],...], on static maps length_m, start_m, goal_m and points_m in
/// the map's frame, evaluations, iterations, checks, digest, backend, threads, threads_used, wall_s, user_s,
/// system_s, note, counters (an object, name to number). `optimum` is the track's, which the gap counts from.
/// What has no value is null. One key per line, no newline at the end.
std::string to_json(const TrialRow& row, const Scenario& scenario,
                    const std::optional<InMetres>& metres = std::nullopt);

}  // namespace pathrace::results
