// How long a campaign will take, from a pilot that is never recorded.
#pragma once

#include <vector>

#include "bench/runner.hpp"

namespace pathrace::bench {

struct Estimate {
  double wall_s = 0;       ///< for the given trials with the given options
  std::size_t pilots = 0;  ///< trials it is based on
};

/// Runs one trial of each planner on each size of map, the heaviest groups first, each cut after a fraction
/// of a second, until about two seconds are gone; a cut trial counts by the share of its budget that it
/// spent.
Estimate estimate_time(const TrialPlan& plan, const std::vector<std::size_t>& trials,
                       const RunOptions& options);

}  // namespace pathrace::bench
