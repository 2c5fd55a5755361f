// Which of the cells that look equally good D* Lite expands first.
#pragma once

#include <array>
#include <string_view>
#include <utility>

#include "core/names.hpp"

namespace pathrace::baselines {

enum class TieRule {
  paper,       ///< the one nearer to the goal, which is where the search comes from
  near_robot,  ///< cells whose g is too small, then the one nearer to the robot
};

}  // namespace pathrace::baselines

namespace pathrace {

template <>
inline constexpr auto names_of<baselines::TieRule> =
    std::to_array<std::pair<baselines::TieRule, std::string_view>>({
        {baselines::TieRule::paper, "paper"},
        {baselines::TieRule::near_robot, "near_robot"},
    });

}  // namespace pathrace
