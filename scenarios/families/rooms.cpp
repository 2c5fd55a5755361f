// Rooms: a lattice of square rooms, walls one cell thick, doors between neighbours.
//
// Doors along a random spanning tree join all rooms; any other pair of neighbours has a door with probability
// `doors`. Each door lies somewhere along its wall.
#include <algorithm>

#include "scenarios/families/spanning.hpp"
#include "scenarios/families/trap.hpp"
#include "scenarios/generated.hpp"

namespace pathrace::scenarios {
namespace {

struct RoomSettings : Placement {
  int room = 5;
  int doors = 50;
  int door = 1;
};

// The part of a wall from `first` to `last`, one cell thick, that becomes a door.
void open_door(OccupancyGrid& grid, Cell first, Cell last, int width, Stream& stream) {
  const int length = std::max(last.x - first.x, last.y - first.y) + 1;
  const int open = std::min(width, length);
  const int shift = stream.between(0, length - open);
  for (int i = shift; i < shift + open; ++i) {
    grid.clear(first.x == last.x ? Cell{first.x, first.y + i} : Cell{first.x + i, first.y});
  }
}

Sketch draw(const RoomSettings& settings, int n, Stream& stream) {
  Sketch sketch{OccupancyGrid(n, n), {}, {}};
  const int side = std::min(settings.room, n);
  const int pitch = side + 1;
  const int rooms = (n + pitch - 1) / pitch;  // the last may be cut by the map's edge
  for (int i = 1; i < rooms; ++i) {
    wall(sketch.grid, {i * pitch - 1, 0}, {i * pitch - 1, n - 1});
    wall(sketch.grid, {0, i * pitch - 1}, {n - 1, i * pitch - 1});
  }
  const SpanningTree tree(rooms, rooms, stream);
  const double doors = settings.doors / 100.0;
  for (int row = 0; row < rooms; ++row) {
    for (int column = 0; column < rooms; ++column) {
      const Cell first{column * pitch, row * pitch};
      const Cell last{std::min(first.x + side, n) - 1, std::min(first.y + side, n) - 1};
      const bool right = column + 1 < rooms && (stream.chance(doors) || tree.opens_right(column, row));
      const bool down = row + 1 < rooms && (stream.chance(doors) || tree.opens_down(column, row));
      if (right) open_door(sketch.grid, {last.x + 1, first.y}, {last.x + 1, last.y}, settings.door, stream);
      if (down) open_door(sketch.grid, {first.x, last.y + 1}, {last.x, last.y + 1}, settings.door, stream);
    }
  }
  return sketch;
}

}  // namespace

Family rooms_family() {
  const GeneratedCard card{
      "rooms", "square rooms with doors between them, ends far apart", "room", Ends::far, {"20-5", "64-8"}};
  return generated_family<RoomSettings>(
      card,
      {integer("room", &RoomSettings::room, 1, 1024, "cells", Source::ours, "side of a room"),
       integer("doors", &RoomSettings::doors, 0, 100, "%", Source::ours,
               "chance of a door where none is needed to join the rooms"),
       integer("door", &RoomSettings::door, 1, 64, "cells", Source::ours,
               "width of a door, at most the room's")},
      draw);
}

}  // namespace pathrace::scenarios
