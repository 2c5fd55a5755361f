// L trap: two walls that meet in a corner between start and goal, open towards the start.
//
// Start and goal lie in opposite corners of the map; a walk that heads for the goal runs into the inner
// corner of the L and has to undo its way along one of the arms.
#include "scenarios/families/trap.hpp"

namespace pathrace::scenarios {
namespace {

Sketch draw(const TrapSettings& settings, int n, Stream& stream) {
  Sketch sketch{OccupancyGrid(n, n), {0, 0}, {n - 1, n - 1}};
  const Cell corner{stream.between(share_of(n, 0.55), n - 2), stream.between(share_of(n, 0.55), n - 2)};
  const int left_arm = length_of(settings.depth, n, 30, 100, 1, corner.x - 1, stream);
  const int upper_arm = length_of(settings.depth, n, 30, 100, 1, corner.y - 1, stream);
  wall(sketch.grid, corner, {corner.x - left_arm, corner.y});
  wall(sketch.grid, corner, {corner.x, corner.y - upper_arm});
  return sketch;
}

}  // namespace

Family trap_l_family() {
  return trap_family("trap-l", "an L-shaped wall, its inside towards the start", TrapAxis::diagonal,
                     {trap_depth(90, "length of both arms")}, draw);
}

}  // namespace pathrace::scenarios
