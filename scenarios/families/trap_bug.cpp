// Bug trap: a meander of walls that crosses the straight way from start to goal again and again.
//
// The worst case of the bug algorithms, whose path grows with the number of times that an obstacle cuts the
// line from start to goal (V. Lumelsky, A. Stepanov, "Path-planning strategies for a point mobile automaton",
// Algorithmica 2, 1987). One wall goes up and down across that line; its folds open by turns to either side,
// and the only ways are around its two ends.
#include <algorithm>

#include "scenarios/families/trap.hpp"

namespace pathrace::scenarios {
namespace {

Sketch draw(const TrapSettings& settings, int n, Stream& stream) {
  const int row = n / 2;
  Sketch sketch{OccupancyGrid(n, n), {0, row}, {n - 1, row}};
  const int pitch = 1 + length_of(settings.mouth, n, 5, 15, 1, n - 4, stream);  // wall and fold
  const int crossings = number_of(settings.nesting, 3, 7, (n - 3) / pitch + 1, stream);
  const int reach = length_of(settings.depth, n, 40, 90, 2, n - 2, stream);  // height of the meander
  const int above = stream.between(std::max(1, reach / 3), std::max(1, reach - reach / 3));
  const int top = std::max(1, row - above);
  const int bottom = std::min(n - 2, row + std::max(1, reach - above));
  const int left = stream.between(1, n - 2 - pitch * (crossings - 1));
  const bool first_closes_below = stream.below(2) == 1;
  for (int i = 0; i < crossings; ++i) {
    const int x = left + pitch * i;
    wall(sketch.grid, {x, top}, {x, bottom});
    if (i == 0) continue;
    const int y = (i % 2 == 1) == first_closes_below ? bottom : top;
    wall(sketch.grid, {x - pitch, y}, {x, y});
  }
  return sketch;
}

}  // namespace

Family trap_bug_family() {
  return trap_family("trap-bug", "a meander that crosses the straight way again and again", TrapAxis::row,
                     {trap_depth(90, "height of the meander"), trap_mouth(40, "width of its folds"),
                      trap_nesting(1000, "number of crossings")},
                     draw);
}

}  // namespace pathrace::scenarios
