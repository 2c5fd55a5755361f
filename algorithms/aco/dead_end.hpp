// Dead ends: what an ant does when every neighbour is on its tabu list.
#pragma once

#include <array>
#include <string_view>
#include <utility>

#include "core/names.hpp"

namespace pathrace::algorithms {

enum class DeadEnd {
  die,        ///< it is discarded and deposits nothing
  backtrack,  ///< it steps back along its path until some neighbour is new; cells left that way stay tabu
  revisit_with_loop_erasure,  ///< it steps on any neighbour by eq. (1); a loop thus closed is cut off its
                              ///< path
};

}  // namespace pathrace::algorithms

namespace pathrace {
template <>
inline constexpr auto names_of<algorithms::DeadEnd> =
    std::to_array<std::pair<algorithms::DeadEnd, std::string_view>>({
        {algorithms::DeadEnd::die, "die"},
        {algorithms::DeadEnd::backtrack, "backtrack"},
        {algorithms::DeadEnd::revisit_with_loop_erasure, "revisit_with_loop_erasure"},
    });
}  // namespace pathrace
