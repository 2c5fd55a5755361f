// What a run says about its failures when it ends.
#pragma once

#include <string>
#include <vector>

#include "results/outcome_count.hpp"

namespace pathrace::bench {

/// At most two lines: how many trials of which planners gave up or failed, and a warning about claims that
/// there is no way where one is proven. Empty where all is well.
std::vector<std::string> failure_lines(const std::vector<results::OutcomeCount>& outcomes);

}  // namespace pathrace::bench
