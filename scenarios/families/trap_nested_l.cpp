// Nested L trap: L-shaped walls one inside another, all open towards the start.
//
// Leaving one L along an arm leads into the next; each is as deep as the first. Start and goal lie in
// opposite corners.
#include <algorithm>

#include "scenarios/families/trap.hpp"

namespace pathrace::scenarios {
namespace {

Sketch draw(const TrapSettings& settings, int n, Stream& stream) {
  constexpr int gap = 2;  // from wall to wall: one lane
  Sketch sketch{OccupancyGrid(n, n), {0, 0}, {n - 1, n - 1}};
  const int room = n - 2 - share_of(n, 0.4);  // the innermost corner stays beyond 40 % of the side
  const int layers = number_of(settings.nesting, 2, 4, 1 + room / gap, stream);
  const int outer = n - 2 - stream.between(0, room - gap * (layers - 1));
  for (int layer = 0; layer < layers; ++layer) {
    const int corner = outer - gap * layer;
    const int left_arm = length_of(settings.depth, n, 30, 90, 1, corner - 1, stream);
    const int upper_arm = length_of(settings.depth, n, 30, 90, 1, corner - 1, stream);
    wall(sketch.grid, {corner, corner}, {corner - left_arm, corner});
    wall(sketch.grid, {corner, corner}, {corner, corner - upper_arm});
  }
  return sketch;
}

}  // namespace

Family trap_nested_l_family() {
  return trap_family("trap-nested-l", "L-shaped walls one inside another", TrapAxis::diagonal,
                     {trap_depth(90, "length of the arms"), trap_nesting(1000, "number of walls")}, draw);
}

}  // namespace pathrace::scenarios
