// The planners of the Open Motion Planning Library, on the any-angle track.
#pragma once

#include <vector>

#include "core/catalogue.hpp"

namespace pathrace::baselines {

/// One card per line of ompl/planners.def.
std::vector<PlannerCard> ompl_cards();

}  // namespace pathrace::baselines
