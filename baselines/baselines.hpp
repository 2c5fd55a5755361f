// The yardsticks: exact search and the floor baselines.
#pragma once

#include <vector>

#include "core/catalogue.hpp"

namespace pathrace::baselines {

/// One card per line of planners.def.
std::vector<PlannerCard> cards();

}  // namespace pathrace::baselines
