// Hook trap: an L whose arms end in lips that bend back, so that sliding along an arm does not lead out.
//
// Start and goal lie in opposite corners. A walk that has run into the inner corner and follows an arm ends
// in the small pocket behind its lip; the way out is the gap between the two lips.
#include <algorithm>

#include "scenarios/families/trap.hpp"

namespace pathrace::scenarios {
namespace {

Sketch draw(const TrapSettings& settings, int n, Stream& stream) {
  Sketch sketch{OccupancyGrid(n, n), {0, 0}, {n - 1, n - 1}};
  const Cell corner{stream.between(share_of(n, 0.65), n - 2), stream.between(share_of(n, 0.65), n - 2)};
  const int left_arm = length_of(settings.depth, n, 40, 100, 2, corner.x - 1, stream);
  const int upper_arm = length_of(settings.depth, n, 40, 100, 2, corner.y - 1, stream);
  const int shorter_arm = std::min(left_arm, upper_arm);
  const int mouth = length_of(settings.mouth, n, 20, 50, 2, shorter_arm, stream);
  const int lip = std::max(0, shorter_arm - mouth);
  wall(sketch.grid, corner, {corner.x - left_arm, corner.y});
  wall(sketch.grid, corner, {corner.x, corner.y - upper_arm});
  wall(sketch.grid, {corner.x - left_arm, corner.y},
       {corner.x - left_arm, corner.y - std::min(lip, upper_arm - 1)});
  wall(sketch.grid, {corner.x, corner.y - upper_arm},
       {corner.x - std::min(lip, left_arm - 1), corner.y - upper_arm});
  return sketch;
}

}  // namespace

Family trap_hook_family() {
  return trap_family("trap-hook", "an L whose arms end in lips that bend back to the start",
                     TrapAxis::diagonal,
                     {trap_depth(90, "length of both arms"),
                      trap_mouth(80, "the shorter arm less the lips, which leave this gap")},
                     draw);
}

}  // namespace pathrace::scenarios
