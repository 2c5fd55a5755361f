// One trial of a planner of OMPL.
#pragma once

#include "baselines/ompl/entry.hpp"
#include "core/planner.hpp"

namespace pathrace::baselines {

/// What the adapter adds to a planner's own parameters.
struct OmplSettings {
  double goal_radius = 0.5;
  std::uint64_t max_calls = 0;
  bool simplify = false;
};

/// Makes the planner, sets the parameters that it declares, by name, and lets it run until it has what it
/// wants or the budget is spent. Seeds come from the context's stream. Answers on the any-angle track.
Answer race(const MakeOmplPlanner& make, const OmplSettings& settings, const ParameterValues& declared,
            const Problem& problem, Context& context);

}  // namespace pathrace::baselines
