// A scenario under another move rule than its own: `dense/20-20/7,rule=free`.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "core/scenario.hpp"

namespace pathrace::scenarios {

/// The scenario itself when the rule is its own; otherwise the same question under the rule, with an id of
/// its own and without a proven optimum. Throws InputError for a dynamic world, which has no moves of cells.
Scenario under_rule(Scenario scenario, MoveRule rule);

/// The id without ",rule=...", and the rule where it has one. Throws InputError for an unknown rule.
std::pair<std::string, std::optional<MoveRule>> split_rule(std::string_view id);

}  // namespace pathrace::scenarios
