// U trap: the start lies inside a cup whose bottom stands between it and the goal.
//
// The cup opens away from the goal; the way leads out backwards and around one of the arms.
#include <algorithm>

#include "scenarios/families/trap.hpp"

namespace pathrace::scenarios {
namespace {

Sketch draw(int n, Stream& stream) {
  const int bottom = stream.between(share_of(n, 0.6), n - 2);                   // column of the cup's bottom
  const int depth = stream.between(std::max(2, share_of(n, 0.3)), bottom - 1);  // length of the arms
  const int half_width = stream.between(1, std::max(1, share_of(n, 0.3) - 1));
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
  return trap_family("trap-u", "a cup around the start, its bottom towards the goal", draw);
}

}  // namespace pathrace::scenarios
