// A MovingAI scen file through one planner: is every optimum right, and how fast is it?
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/catalogue.hpp"
#include "scenarios/movingai/map_file.hpp"
#include "scenarios/movingai/scen_file.hpp"

namespace pathrace::bench {

struct ScenReport {
  std::size_t queries = 0;  ///< matched + mismatched + bad_queries
  std::size_t matched = 0;  ///< solved, with the recorded optimum; any-angle paths may be shorter
  /// Longer, illegal, or no path; at any angle, also shorter than the proven any-angle optimum.
  std::size_t mismatched = 0;
  /// Out of bounds, a blocked end, another map size, or a legal path below the optimum.
  std::size_t bad_queries = 0;
  double setup_us = 0;  ///< binding the planner to the map, once
  double us_per_query_mean = 0;
  double us_per_query_median = 0;
  std::uint64_t expansions = 0;  ///< checks of all measured queries
  double expansions_per_second = 0;
  std::vector<std::string> remarks;  ///< one line for each query that did not match
};

/// Runs `limit` queries spread evenly over the file, each `repeat` times; a query's time is the median of its
/// repetitions. Judging is not timed.
ScenReport bench_scen(const scenarios::MapFile& map, const scenarios::ScenFile& scen, const Entrant& entrant,
                      std::size_t limit, int repeat);

}  // namespace pathrace::bench
