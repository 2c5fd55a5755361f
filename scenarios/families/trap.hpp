// What the trap families share: their parameters, walls, and the ways to turn a sketch.
//
// A trap is drawn with its goal to the east of the start (axis `row`) or to the south-east (`diagonal`), then
// turned by quarter turns and possibly mirrored along that axis: every trap opens to every side. Lengths are
// percentages of the map's side, so that a parameter means the same trap at any size; those that an id does
// not name are drawn from its seed.
#pragma once

#include <array>
#include <functional>
#include <string_view>
#include <utility>

#include "core/names.hpp"
#include "scenarios/generated.hpp"

namespace pathrace::scenarios {

/// Where the goal lies as seen from the start.
enum class Facing {
  any,    ///< drawn from the seed
  east,   ///< south-east for diagonal traps, and so on clockwise
  south,  ///< south-west
  west,   ///< north-west
  north,  ///< north-east
};

enum class TrapAxis { row, diagonal };

}  // namespace pathrace::scenarios

namespace pathrace {
template <>
inline constexpr auto names_of<scenarios::Facing> =
    std::to_array<std::pair<scenarios::Facing, std::string_view>>({
        {scenarios::Facing::any, "any"},
        {scenarios::Facing::east, "east"},
        {scenarios::Facing::south, "south"},
        {scenarios::Facing::west, "west"},
        {scenarios::Facing::north, "north"},
    });
}  // namespace pathrace

namespace pathrace::scenarios {

/// 0 stands for "drawn from the seed".
struct TrapSettings : Placement {
  int depth = 0;    ///< percent of the side
  int mouth = 0;    ///< percent of the side
  int nesting = 0;  ///< how many times the trap repeats inside itself
  Facing facing = Facing::any;
};

/// The fields a family may have; `meaning` says what they are for this trap.
Field<TrapSettings> trap_depth(int most_percent, const std::string& meaning);
Field<TrapSettings> trap_mouth(int most_percent, const std::string& meaning);
Field<TrapSettings> trap_nesting(int most, const std::string& meaning);

/// The card of a family `name/<n>/<seed>` in sizes 10 and 20. `draw(settings, n, stream)` is its sketch
/// before turning; `facing` is added to the fields.
Family trap_family(const std::string& name, const std::string& summary, TrapAxis axis,
                   std::vector<Field<TrapSettings>> fields,
                   std::function<Sketch(const TrapSettings&, int, Stream&)> draw);

/// Blocks the cells of the rectangle from one corner to the other, both included, that lie on the map.
void wall(OccupancyGrid& grid, Cell from, Cell to);

/// `share` of n, rounded to the nearest integer.
int share_of(int n, double share);

/// A length in cells: `percent` of n where given, else drawn from low..high percent; within least..most.
int length_of(int percent, int n, int low, int high, int least, int most, Stream& stream);
/// A number: the given one, else drawn from low..high; at most `most`, at least 1.
int number_of(int given, int low, int high, int most, Stream& stream);

}  // namespace pathrace::scenarios
