// One trial as a JSON object, for scripts.
#pragma once

#include <string>

#include "core/scenario.hpp"
#include "results/row.hpp"

namespace pathrace::results {

/// Keys in this order: scenario, planner, verdict, track, rule, length, optimum, gap, turns, `cells`
/// (lattice) or `points` (any_angle) as [[x,y],...], evaluations, iterations, checks, digest, backend,
/// threads, threads_used, wall_s, user_s, system_s, note, counters (an object, name to number). `optimum` is
/// the track's, which the gap counts from. What has no value is null. One key per line, no newline at the
/// end.
std::string to_json(const TrialRow& row, const Scenario& scenario);

}  // namespace pathrace::results
