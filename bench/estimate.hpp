// How long a campaign will take, from a pilot that is never recorded.
#pragma once

#include <vector>

#include "bench/runner.hpp"

namespace pathrace::bench {

struct Estimate {
  double wall_s = 0;            ///< for the given trials with the given options
  std::vector<double> trial_s;  ///< what each of them is expected to take, in their order
  std::size_t pilots = 0;       ///< trials it is based on
};

/// Runs trials of each planner on each size of map, up to three on scenarios far apart in the list: first one
/// of each group, the heaviest groups first, then the second of each. Each is cut after a fraction of a
/// second, all end after about two; a cut trial counts by the share of its budget that it spent.
Estimate estimate_time(const TrialPlan& plan, const std::vector<std::size_t>& trials,
                       const RunOptions& options);

}  // namespace pathrace::bench
