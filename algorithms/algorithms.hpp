// The yardsticks: exact search and the floor algorithms.
#pragma once

#include <vector>

#include "core/catalogue.hpp"

namespace pathrace::algorithms {

/// One card per line of planners.def.
std::vector<PlannerCard> cards();

}  // namespace pathrace::algorithms
