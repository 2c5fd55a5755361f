// Tunnel trap: a thick wall across the whole map with one narrow tunnel, off the straight way.
//
// Nothing but the tunnel leads through; a walk that heads for the goal slides along the wall past its mouth.
// Start and goal lie in opposite corners.
#include <algorithm>

#include "scenarios/families/trap.hpp"

namespace pathrace::scenarios {
namespace {

Sketch draw(const TrapSettings& settings, int n, Stream& stream) {
  Sketch sketch{OccupancyGrid(n, n), {0, 0}, {n - 1, n - 1}};
  const int thickness = length_of(settings.depth, n, 10, 30, 1, n - 2, stream);
  const int width = length_of(settings.mouth, n, 1, 8, 1, n - 1, stream);
  const int top = stream.between(1, n - 1 - thickness);
  const bool at_start = stream.below(2) == 1;  // the mouth lies near one of the map's two sides
  const int shift = stream.between(0, std::min(share_of(n, 0.25), n - width));
  const int left = at_start ? shift : n - width - shift;
  if (left > 0) wall(sketch.grid, {0, top}, {left - 1, top + thickness - 1});
  if (left + width < n) wall(sketch.grid, {left + width, top}, {n - 1, top + thickness - 1});
  return sketch;
}

}  // namespace

Family trap_tunnel_family() {
  return trap_family("trap-tunnel", "a thick wall with one narrow tunnel off the straight way",
                     TrapAxis::diagonal,
                     {trap_depth(90, "length of the tunnel"), trap_mouth(50, "width of the tunnel")}, draw);
}

}  // namespace pathrace::scenarios
