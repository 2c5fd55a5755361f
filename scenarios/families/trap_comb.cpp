// Comb trap: a row of deep pockets between the teeth of a comb, all open towards the start.
//
// The comb's back keeps one cell from the map's edges, so that the way leads past its ends. Start and goal
// lie in opposite corners.
#include <algorithm>

#include "scenarios/families/trap.hpp"

namespace pathrace::scenarios {
namespace {

Sketch draw(const TrapSettings& settings, int n, Stream& stream) {
  Sketch sketch{OccupancyGrid(n, n), {0, 0}, {n - 1, n - 1}};
  const int back = stream.between(std::min(share_of(n, 0.7), n - 2), n - 2);  // row of the comb's back
  const int depth = length_of(settings.depth, n, 30, 70, 1, back - 1, stream);
  const int pitch = 1 + length_of(settings.mouth, n, 8, 20, 1, n - 4, stream);  // tooth and pocket
  const int left = stream.between(1, std::max(1, std::min(n / 5, n - 2 - pitch)));
  const int pockets = std::max(1, (n - 2 - left) / pitch);
  const int right = std::min(n - 2, left + pockets * pitch);
  wall(sketch.grid, {left, back}, {right, back});
  for (int x = left; x <= right; x += pitch) wall(sketch.grid, {x, back - depth}, {x, back});
  return sketch;
}

}  // namespace

Family trap_comb_family() {
  return trap_family("trap-comb", "pockets between the teeth of a comb, open to the start",
                     TrapAxis::diagonal,
                     {trap_depth(90, "length of the teeth"), trap_mouth(60, "width of a pocket")}, draw);
}

}  // namespace pathrace::scenarios
