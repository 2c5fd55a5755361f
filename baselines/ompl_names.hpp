// The names of OMPL's planners, known without OMPL.
#pragma once

#include <string>
#include <vector>

namespace pathrace::baselines {

/// One per line of ompl/planners.def.
std::vector<std::string> ompl_names();

}  // namespace pathrace::baselines
