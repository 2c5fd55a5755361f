// What a user of OMPL writes without this adapter: the yardstick for its cost.
//
// The library's own plane, a lambda that looks up one cell, motions sampled every half per cent of the map's
// extent. Nothing is metered but the lookups, and what it finds may cut a corner between two samples.
#pragma once

#include <cstdint>

#include "core/planner.hpp"

namespace pathrace::baselines {

enum class PlainPlanner { rrt_connect, rrt_star };

struct PlainRun {
  bool solved = false;
  std::uint64_t lookups = 0;
};

/// Runs until solved, or until the planner has asked `calls` times whether to stop.
PlainRun plain_loop(PlainPlanner kind, const Problem& problem, const Stream& stream, std::uint64_t calls);

}  // namespace pathrace::baselines
