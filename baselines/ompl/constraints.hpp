// What OMPL 1.5 demands of parameters beyond the ranges that it suggests. Where a demand is not met, the
// library throws in setup(), goes on with other values, or crashes.
#pragma once

#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "baselines/ompl/declared.hpp"

namespace pathrace::baselines {

/// The values of a number that the planner with these parameters accepts, first and last, where the library
/// suggests others too.
std::optional<std::pair<double, double>> accepted_range(const ompl::base::ParamSet& parameters,
                                                        std::string_view name);

/// The conditions all of whose parameters are declared. They read every declared value, in canonical
/// spelling.
std::vector<Condition<ParameterValues>> conditions_on(const std::vector<DeclaredParameter>& declared);

}  // namespace pathrace::baselines
