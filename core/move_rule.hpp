// Which diagonal steps a robot may take past obstacles. The one choice that changes every length on a
// grid, so it is always explicit (algorithms.md 0.2).
#pragma once

#include <array>
#include <string_view>
#include <utility>

#include "core/names.hpp"

namespace pathrace {

enum class MoveRule {
  four,     ///< no diagonal steps
  strict,   ///< a diagonal needs both side cells free (MovingAI's convention; the default)
  squeeze,  ///< a diagonal needs at least one side cell free
  free,     ///< a diagonal needs only its target free
};

template <>
inline constexpr auto names_of<MoveRule> = std::to_array<std::pair<MoveRule, std::string_view>>({
    {MoveRule::four, "four"},
    {MoveRule::strict, "strict"},
    {MoveRule::squeeze, "squeeze"},
    {MoveRule::free, "free"},
});

}  // namespace pathrace
