// Pockets: many small dead ends scattered over the map, each open towards the start.
//
// A pocket is a lane one or two cells wide with walls on three sides. Pockets keep one cell apart, so that a
// way always leads between them; start and goal lie in opposite corners.
#include <algorithm>

#include "scenarios/families/trap.hpp"

namespace pathrace::scenarios {
namespace {

constexpr int longest_pocket = 8;

struct Pocket {
  Cell corner;  // upper left of the bounding box, walls included
  int width;
  int height;
  bool opens_left;  // else it opens upwards
};

Pocket draw_pocket(const TrapSettings& settings, int n, Stream& stream) {
  const int lane =
      settings.mouth > 0 ? length_of(settings.mouth, n, 0, 0, 1, n - 3, stream) : stream.between(1, 2);
  const int usual = std::clamp(n / 6, 1, longest_pocket);
  const int depth =
      settings.depth > 0 ? length_of(settings.depth, n, 0, 0, 1, n - 2, stream) : stream.between(1, usual);
  const bool opens_left = stream.below(2) == 1;
  const int across = lane + 2;
  const int along = depth + 1;
  Pocket pocket{{0, 0}, opens_left ? along : across, opens_left ? across : along, opens_left};
  pocket.corner = {stream.between(0, std::max(0, n - pocket.width)),
                   stream.between(0, std::max(0, n - pocket.height))};
  return pocket;
}

// Free for the pocket: its box with one more cell around holds no wall, no start and no goal.
bool fits(const Sketch& sketch, const Pocket& pocket) {
  const int n = sketch.grid.width();
  if (pocket.corner.x + pocket.width > n || pocket.corner.y + pocket.height > n) return false;
  for (int y = pocket.corner.y - 1; y <= pocket.corner.y + pocket.height; ++y) {
    for (int x = pocket.corner.x - 1; x <= pocket.corner.x + pocket.width; ++x) {
      const Cell cell{x, y};
      if (cell == sketch.start || cell == sketch.goal) return false;
      if (sketch.grid.contains(cell) && !sketch.grid.is_free(cell)) return false;
    }
  }
  return true;
}

void build(OccupancyGrid& grid, const Pocket& pocket) {
  const Cell first = pocket.corner;
  const Cell last{first.x + pocket.width - 1, first.y + pocket.height - 1};
  if (pocket.opens_left) {
    wall(grid, first, {last.x, first.y});
    wall(grid, {first.x, last.y}, last);
    wall(grid, {last.x, first.y}, last);
  } else {
    wall(grid, first, {first.x, last.y});
    wall(grid, {last.x, first.y}, last);
    wall(grid, {first.x, last.y}, last);
  }
}

Sketch draw(const TrapSettings& settings, int n, Stream& stream) {
  Sketch sketch{OccupancyGrid(n, n), {0, 0}, {n - 1, n - 1}};
  const int tries = std::max(8, n * n / 8);
  for (int i = 0; i < tries; ++i) {
    const Pocket pocket = draw_pocket(settings, n, stream);
    if (fits(sketch, pocket)) build(sketch.grid, pocket);
  }
  return sketch;
}

}  // namespace

Family trap_pocket_family() {
  return trap_family("trap-pocket", "many small dead ends, open towards the start", TrapAxis::diagonal,
                     {trap_depth(40, "length of the pockets"), trap_mouth(20, "width of their lanes")}, draw);
}

}  // namespace pathrace::scenarios
