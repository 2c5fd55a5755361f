// Where start and goal lie on a generated map.
//
// Every rule keeps to the largest region of the map, so that there is always a way.
#pragma once

#include <array>
#include <string_view>
#include <utility>
#include <vector>

#include "core/names.hpp"
#include "core/parameters.hpp"
#include "core/stream.hpp"
#include "scenarios/family.hpp"

namespace pathrace::scenarios {

enum class Ends {
  own,      ///< as the family has it
  corners,  ///< the cells of the region nearest to the upper left and to the lower right corner
  far,      ///< two cells, each of which is farthest from the other
  random,   ///< a random start, and a goal at `difficulty` percent of the start's greatest distance
};

}  // namespace pathrace::scenarios

namespace pathrace {
template <>
inline constexpr auto names_of<scenarios::Ends> =
    std::to_array<std::pair<scenarios::Ends, std::string_view>>({
        {scenarios::Ends::own, "own"},
        {scenarios::Ends::corners, "corners"},
        {scenarios::Ends::far, "far"},
        {scenarios::Ends::random, "random"},
    });
}  // namespace pathrace

namespace pathrace::scenarios {

struct Placement {
  Ends ends = Ends::own;
  int difficulty = 50;  ///< percent, for `random` alone
};

std::vector<Field<Placement>> placement_fields();

/// Puts start and goal by the rule, which is not `own`; false when no region has two cells.
///
/// `far` searches from a random cell, from the cell farthest from there, and so on until the distance grows
/// no more: the greatest distance of the map on a maze without loops, elsewhere close to it. `random` takes
/// the goal uniformly from the cells whose distance is within 5 points of `difficulty`.
bool place_ends(Sketch& sketch, Ends rule, int difficulty, Stream& stream);

}  // namespace pathrace::scenarios
