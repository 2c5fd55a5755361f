// The runner: many trials side by side, each record handed over once it is there.
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "bench/executors.hpp"
#include "bench/map_loan.hpp"
#include "bench/trial_plan.hpp"
#include "core/record.hpp"

namespace pathrace::bench {

struct RunOptions {
  std::string backend = default_backend();
  int jobs = 1;                       ///< trials side by side
  int threads = 1;                    ///< for each planner
  bool check_map = maps_are_checked;  ///< whether a planner changes the map (MapLoan)
};

/// Called from several threads at once, in any order; `scenario` has what its trials' gaps
/// count from.
using Sink = std::function<void(const Trial&, const Scenario& scenario, TrialRecord)>;

/// Runs the trials with these indices. Stops dealing new ones when `stop` becomes true; those that
/// `stop_requested` (core/checkpoint.hpp) cut short are not handed over. Everything in a
/// record but its costs depends on the trial's key alone.
void run_trials(const TrialPlan& plan, const std::vector<std::size_t>& trials, const RunOptions& options,
                const std::atomic<bool>& stop, const Sink& sink);

}  // namespace pathrace::bench
