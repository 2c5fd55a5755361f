// Steps off the beaten track: of ants that are stuck.
#include "algorithms/aco/choice.hpp"
#include "algorithms/aco/walker.hpp"

namespace pathrace::algorithms {

void Walker::settle(Lane& lane) {
  for (const std::uint32_t cell : {lane.cell, lane.behind, lane.further}) lane.marks[cell] = lane.mark;
  lane.behind = lane.further = lane.cell;
  lane.recent = {};
}

// A step off the beaten track; the lane is settled before and after.
void Walker::move(Lane& lane, int direction) const {
  lane.cell = static_cast<std::uint32_t>(ground_.nest.moves().step(lane.cell, direction));
  *lane.next++ = static_cast<std::uint8_t>(direction);
  if (!lane.place.empty()) lane.place[lane.cell] = static_cast<std::uint32_t>(lane.length() + 1);
  settle(lane);
}

unsigned Walker::unvisited(const Lane& lane) const {
  unsigned mask = 0;
  for (int d = 0; d < direction_count; ++d) {
    const bool open = (ground_.nest.open(lane.cell) >> d & 1) != 0;
    if (open && lane.marks[ground_.nest.moves().step(lane.cell, d)] != lane.mark) mask |= 1U << d;
  }
  return mask;
}

// No step has a weight. Where steps are left whose weights have underflown, no preference is left among them.
Walker::Outcome Walker::stuck(std::size_t k) {
  Lane& lane = lanes_[k];
  if (lane.behind != lane.cell) settle(lane);
  const unsigned fresh = ground_.trail.every_step_weighs() ? 0 : unvisited(lane);
  if (fresh != 0) {
    move(lane, uniform_choice(fresh, lower_uniform(draws_.bits(k))));
    return lane.cell == ground_.nest.goal() ? Outcome::arrived : Outcome::goes_on;
  }
  switch (ground_.dead_end) {
    case DeadEnd::die: return Outcome::died;
    case DeadEnd::backtrack: return back_up(lane);
    case DeadEnd::revisit_with_loop_erasure: break;
  }
  return revisit(k);
}

Walker::Outcome Walker::back_up(Lane& lane) const {
  if (lane.length() == 0) return Outcome::died;  // all that can be reached has been seen
  const std::uint8_t direction = *--lane.next;
  lane.cell = static_cast<std::uint32_t>(ground_.nest.moves().step(lane.cell, opposite(direction)));
  fetch(lane, ground_.trail.rows() + lane.cell, static_cast<std::ptrdiff_t>(ground_.nest.stride()));
  lane.behind = lane.further = lane.cell;  // marked long ago, like all of the path
  if (ground_.keep_popped) lane.popped.push_back({lane.cell, direction});
  return Outcome::goes_on;
}

// A step onto any neighbour by eq. (1). Where the path has been there, the loop is cut off; else it goes on
// from there.
Walker::Outcome Walker::revisit(std::size_t k) {
  Lane& lane = lanes_[k];
  const unsigned open = ground_.nest.open(lane.cell);
  if (open == 0) return Outcome::died;
  scalar::Weights weights;
  for (int d = 0; d < direction_count; ++d) {
    weights[static_cast<std::size_t>(d)] = ground_.trail.weight(lane.cell, d);
  }
  const std::uint64_t bits = draws_.another(k);
  int direction = scalar::roulette(weights, upper_uniform(bits));
  if (direction == no_choice) direction = uniform_choice(open, lower_uniform(bits));
  const std::size_t target = ground_.nest.moves().step(lane.cell, direction);
  if (lane.place[target] == 0) {
    move(lane, direction);
    return Outcome::goes_on;
  }
  while (lane.length() + 1 > lane.place[target]) {
    lane.place[lane.cell] = 0;
    const std::uint8_t last = *--lane.next;
    lane.cell = static_cast<std::uint32_t>(ground_.nest.moves().step(lane.cell, opposite(last)));
  }
  settle(lane);
  return Outcome::goes_on;
}

}  // namespace pathrace::algorithms
