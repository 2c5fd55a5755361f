// U trap: the start lies inside a cup whose bottom stands between it and the goal.
//
// The cup opens away from the goal; the way leads out backwards and around one of the arms.
#include <algorithm>

#include "scenarios/families/trap.hpp"

namespace pathrace::scenarios {
namespace {

Sketch draw(const TrapSettings& settings, int n, Stream& stream) {
  const int bottom = stream.between(share_of(n, 0.6), n - 2);  // column of the cup's bottom
  const int depth = length_of(settings.depth, n, 30, 100, 2, bottom - 1, stream);
  const int half_width =
      length_of(settings.mouth, n, 10, 55, 3, n - 4, stream) / 2;      // a lane of one at least
  const int row = stream.between(half_width + 1, n - half_width - 2);  // the cup's axis
  const int inside = stream.between(1, depth - 1);                     // start to bottom
  Sketch sketch{OccupancyGrid(n, n), {bottom - inside, row}, {n - 1, row}};
  wall(sketch.grid, {bottom, row - half_width}, {bottom, row + half_width});
  wall(sketch.grid, {bottom - depth, row - half_width}, {bottom, row - half_width});
  wall(sketch.grid, {bottom - depth, row + half_width}, {bottom, row + half_width});
  return sketch;
}

}  // namespace

Family trap_u_family() {
  return trap_family(
      "trap-u", "a cup around the start, its bottom towards the goal", TrapAxis::row,
      {trap_depth(80, "length of the arms"), trap_mouth(80, "width of the cup, walls included")}, draw);
}

}  // namespace pathrace::scenarios
