// Spiral trap: the goal lies in the middle of a spiral of walls; the only way winds inwards.
//
// The wall is one line that turns right at each corner, `lane` cells from its last round. Start in the upper
// left corner of the map.
#include <algorithm>

#include "scenarios/families/trap.hpp"

namespace pathrace::scenarios {
namespace {

// A round of the spiral: the box whose edges are its walls.
struct Round {
  int left;
  int top;
  int right;
  int bottom;

  Round inside(int lane) const {
    return {left + lane + 1, top + lane + 1, right - lane - 1, bottom - lane - 1};
  }
  bool has_room() const { return right - left >= 2 && bottom - top >= 2; }
};

// Along the top, from where the last round left off, down the right, back along the bottom, and up the left
// as far as the top of the round inside, which goes on from there.
void build(OccupancyGrid& grid, const Round& round, int from_x, int lane) {
  wall(grid, {from_x, round.top}, {round.right, round.top});
  wall(grid, {round.right, round.top}, {round.right, round.bottom});
  wall(grid, {round.right, round.bottom}, {round.left, round.bottom});
  const int turn = round.top + lane + 1;
  if (turn < round.bottom) wall(grid, {round.left, round.bottom}, {round.left, turn});
}

Sketch draw(const TrapSettings& settings, int n, Stream& stream) {
  Sketch sketch{OccupancyGrid(n, n), {0, 0}, {0, 0}};
  const int lane = length_of(settings.mouth, n, 1, 15, 1, std::max(1, n / 4 - 1), stream);
  const int rounds = number_of(settings.nesting, 1, 3, n, stream);
  const int margin = n / 7;
  Round round{1 + stream.between(0, margin), 1 + stream.between(0, margin), n - 2 - stream.between(0, margin),
              n - 2 - stream.between(0, margin)};
  int from_x = round.left;
  for (int i = 0; i < rounds && round.has_room(); ++i) {
    build(sketch.grid, round, from_x, lane);
    sketch.goal = {(round.left + round.right) / 2, (round.top + round.bottom) / 2};
    from_x = round.left;
    round = round.inside(lane);
  }
  return sketch;
}

}  // namespace

Family trap_spiral_family() {
  return trap_family("trap-spiral", "the goal in the middle of a spiral of walls", TrapAxis::diagonal,
                     {trap_mouth(20, "width of the lane"), trap_nesting(1000, "number of rounds")}, draw);
}

}  // namespace pathrace::scenarios
