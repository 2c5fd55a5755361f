// Describing scenarios: what the question is and how hard it looks, as rows of the store.
#pragma once

#include <atomic>
#include <cstddef>

#include "bench/runner.hpp"
#include "bench/trial_plan.hpp"
#include "core/scenario.hpp"
#include "results/scenario_row.hpp"
#include "results/store.hpp"

namespace pathrace::bench {

/// The scenario's row, its optima proven by the way; with the value of every feature when `with_features`.
results::ScenarioRow describe(Scenario scenario, bool with_features);

/// Stores what the store does not yet know about the scenarios of the plan, `options.jobs` side by side, a
/// few at a time and in the plan's order, so that what a killed run has stored is kept. Stops when `stop`
/// becomes true. Returns how many scenarios it described.
std::size_t store_scenarios(const TrialPlan& plan, bool with_features, const RunOptions& options,
                            const std::atomic<bool>& stop, results::Store& store);

}  // namespace pathrace::bench
