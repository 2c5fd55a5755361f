// Mazes: corridors of a given width between walls one cell thick.
//
// A random spanning tree, so that exactly one corridor joins any two places; `loops` opens some of the other
// walls. Columns and rows that no corridor fills are blocked.
#include <algorithm>

#include "scenarios/families/spanning.hpp"
#include "scenarios/generated.hpp"

namespace pathrace::scenarios {
namespace {

struct MazeSettings : Placement {
  int corridor = 1;
  int loops = 0;
};

void carve(OccupancyGrid& grid, Cell first, Cell last) {
  for (int y = first.y; y <= last.y; ++y) {
    for (int x = first.x; x <= last.x; ++x) grid.clear({x, y});
  }
}

OccupancyGrid solid(int n) {
  OccupancyGrid grid(n, n);
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x < n; ++x) grid.block({x, y});
  }
  return grid;
}

Sketch draw(const MazeSettings& settings, int n, Stream& stream) {
  Sketch sketch{solid(n), {}, {}};
  const int width = std::min(settings.corridor, (n - 1) / 2);
  const int pitch = width + 1;
  const int places = (n + 1) / pitch;
  const SpanningTree tree(places, places, stream);
  const double loops = settings.loops / 100.0;
  for (int row = 0; row < places; ++row) {
    for (int column = 0; column < places; ++column) {
      const Cell first{column * pitch, row * pitch};
      const Cell last{first.x + width - 1, first.y + width - 1};
      carve(sketch.grid, first, last);
      const bool right = column + 1 < places && (stream.chance(loops) || tree.opens_right(column, row));
      const bool down = row + 1 < places && (stream.chance(loops) || tree.opens_down(column, row));
      if (right) carve(sketch.grid, {last.x + 1, first.y}, {last.x + 1, last.y});
      if (down) carve(sketch.grid, {first.x, last.y + 1}, {last.x, last.y + 1});
    }
  }
  return sketch;
}

}  // namespace

Family maze_family() {
  const GeneratedCard card{
      "maze", "a maze with corridors of one width, ends far apart", "corridor", Ends::far, {"20-1", "64-2"}};
  return generated_family<MazeSettings>(
      card,
      {integer("corridor", &MazeSettings::corridor, 1, 64, "cells", Source::ours,
               "width of the corridors, at most half of n"),
       integer("loops", &MazeSettings::loops, 0, 100, "%", Source::ours,
               "chance that a wall without a door opens; 0: one way between any two places")},
      draw);
}

}  // namespace pathrace::scenarios
