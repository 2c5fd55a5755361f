// The yardsticks: exact search, the floor baselines, and the planners of OMPL where it is installed.
#pragma once

#include <vector>

#include "core/catalogue.hpp"

namespace pathrace::baselines {

/// One card per line of planners.def and, with OMPL, of ompl/planners.def.
std::vector<PlannerCard> cards();

/// The planners of OMPL where it is not installed; otherwise none.
std::vector<AbsentPlanner> absent_planners();

}  // namespace pathrace::baselines
