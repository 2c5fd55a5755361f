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
  /// Solved with the optimum of the path's track, or rightly without an answer.
  std::size_t matched = 0;
  std::size_t mismatched = 0;  ///< longer, illegal, no path, or shorter than a proven optimum
  /// Out of bounds, a blocked end, another map size, a legal path below the printed optimum, or a printed
  /// optimum where no way exists.
  std::size_t bad_queries = 0;
  /// Of matched and mismatched, those judged against our own proof instead of the file: at any angle, since a
  /// file's optima are 8-connected, and where the file prints 0 between different cells, unknown.
  std::size_t proven_here = 0;
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
