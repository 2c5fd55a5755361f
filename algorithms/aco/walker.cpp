#include "algorithms/aco/walker.hpp"

#include <algorithm>

#include "algorithms/aco/choice.hpp"

namespace pathrace::algorithms {

Walker::Walker(const Ground& ground, std::size_t lanes)
    : ground_(ground), margin_(ground.nest.stride() + 4), lanes_(lanes) {
  for (Lane& lane : lanes_) {
    lane.marks.resize(ground.nest.size() + 2 * margin_);
    lane.directions.resize(ground.nest.free_cells() + 1);
    if (ground.dead_end == DeadEnd::revisit_with_loop_erasure) lane.place.resize(ground.nest.size());
  }
}

void Walker::run(std::size_t begin, std::size_t end, const Stream& stream, std::uint64_t step_limit,
                 const Meter& meter, std::vector<Walk>& walks) {
  stream_ = &stream;
  meter_ = &meter;
  walks_ = &walks;
  limit_ = std::min(step_limit, ground_.max_steps);
  const bool with_places = ground_.dead_end == DeadEnd::revisit_with_loop_erasure;
  if (ground_.q0 > 0) {
    with_places ? run_lanes<true, true>(begin, end) : run_lanes<true, false>(begin, end);
  } else {
    with_places ? run_lanes<false, true>(begin, end) : run_lanes<false, false>(begin, end);
  }
}

template <bool greedy, bool with_places>
void Walker::run_lanes(std::size_t next, std::size_t end) {
  std::size_t under_way = 0;
  while (under_way < lanes_.size() && next < end) begin(lanes_[under_way++], next++);
  while (under_way > 0) {
    for (std::size_t k = 0; k < under_way; ++k) {
      const Outcome outcome = step<greedy, with_places>(lanes_[k]);
      if (outcome == Outcome::goes_on) continue;
      finish(lanes_[k], outcome == Outcome::arrived);
      if (next < end) {
        begin(lanes_[k], next++);
      } else {
        --under_way;
        std::swap(lanes_[k], lanes_[under_way]);
      }
    }
  }
}

void Walker::begin(Lane& lane, std::size_t ant) const {
  if (++lane.mark == 0) {
    std::fill(lane.marks.begin(), lane.marks.end(), std::uint8_t{0});
    lane.mark = 1;
  }
  lane.cell = static_cast<std::uint32_t>(ground_.nest.start());
  lane.length = 0;
  lane.decisions = 0;
  lane.pause = 0;
  lane.pops = 0;
  lane.stream = stream_->fork(ant);
  lane.ant = ant;
  lane.popped.clear();
  marks(lane)[lane.cell] = lane.mark;
  if (!lane.place.empty()) lane.place[lane.cell] = 1;
}

void Walker::finish(Lane& lane, bool arrived) const {
  Walk& walk = (*walks_)[lane.ant];
  walk.arrived = arrived;
  walk.decisions = lane.decisions;
  walk.pops = lane.pops;
  walk.directions.clear();
  if (arrived || ground_.keep_the_dead) {
    walk.directions.assign(lane.directions.begin(), lane.directions.begin() + lane.length);
  }
  walk.length = length_of(walk.directions);
  if (ground_.keep_popped) walk.popped = lane.popped;
  if (lane.place.empty()) return;
  std::size_t cell = ground_.nest.start();
  lane.place[cell] = 0;
  for (std::size_t i = 0; i < lane.length; ++i) {
    cell = ground_.nest.moves().step(cell, lane.directions[i]);
    lane.place[cell] = 0;
  }
}

bool Walker::may_go_on(Lane& lane) const {
  if (lane.decisions == limit_) return false;
  if (lane.decisions > 0 && meter_->out_of_time()) return false;
  lane.pause = std::min(limit_, lane.decisions + clock_interval);
  return true;
}

template <bool with_places>
void Walker::enter(Lane& lane, int direction) const {
  const auto cell = static_cast<std::uint32_t>(ground_.nest.moves().step(lane.cell, direction));
  lane.cell = cell;
  lane.directions[lane.length++] = static_cast<std::uint8_t>(direction);
  marks(lane)[cell] = lane.mark;
  if (with_places) lane.place[cell] = lane.length + 1;
}

template <bool greedy, bool with_places>
Walker::Outcome Walker::step(Lane& lane) const {
  if (lane.decisions == lane.pause && !may_go_on(lane)) return Outcome::died;
  ++lane.decisions;
  const ChoicePoint at{ground_.trail.rows() + lane.cell, marks(lane) + lane.cell,
                       static_cast<std::ptrdiff_t>(ground_.nest.stride()), lane.mark,
                       ground_.trail.least_strength()};
  const std::uint64_t bits = lane.stream.bits();
  const int direction = greedy ? choose(at, bits, static_cast<float>(ground_.q0)) : choose(at, bits);
  if (direction == no_choice) return stuck(lane, bits);
  enter<with_places>(lane, direction);
  return lane.cell == ground_.nest.goal() ? Outcome::arrived : Outcome::goes_on;
}

// No step has a weight. Where steps are left whose weights have underflown, no preference is left among them.
Walker::Outcome Walker::stuck(Lane& lane, std::uint64_t bits) const {
  unsigned fresh = 0;
  for (int d = 0; d < direction_count; ++d) {
    const bool open = (ground_.nest.open(lane.cell) >> d & 1) != 0;
    if (open && marks(lane)[ground_.nest.moves().step(lane.cell, d)] != lane.mark) fresh |= 1U << d;
  }
  if (fresh != 0) {
    const int direction = uniform_choice(fresh, lower_uniform(bits));
    lane.place.empty() ? enter<false>(lane, direction) : enter<true>(lane, direction);
    return lane.cell == ground_.nest.goal() ? Outcome::arrived : Outcome::goes_on;
  }
  switch (ground_.dead_end) {
    case DeadEnd::die: return Outcome::died;
    case DeadEnd::backtrack: return back_up(lane);
    case DeadEnd::revisit_with_loop_erasure: break;
  }
  return revisit(lane);
}

Walker::Outcome Walker::back_up(Lane& lane) const {
  if (lane.length == 0) return Outcome::died;  // all that can be reached has been seen
  const std::uint8_t direction = lane.directions[--lane.length];
  lane.cell = static_cast<std::uint32_t>(ground_.nest.moves().step(lane.cell, opposite(direction)));
  ++lane.pops;
  if (ground_.keep_popped) lane.popped.push_back({lane.cell, direction});
  return Outcome::goes_on;
}

// A step onto any neighbour by eq. (1). Where the path has been there, the loop is cut off; else it goes on
// from there.
Walker::Outcome Walker::revisit(Lane& lane) const {
  const unsigned open = ground_.nest.open(lane.cell);
  if (open == 0) return Outcome::died;
  scalar::Weights weights;
  for (int d = 0; d < direction_count; ++d) {
    weights[static_cast<std::size_t>(d)] = ground_.trail.weight(lane.cell, d);
  }
  const std::uint64_t bits = lane.stream.bits();
  int direction = scalar::roulette(weights, upper_uniform(bits));
  if (direction == no_choice) direction = uniform_choice(open, lower_uniform(bits));
  const std::size_t target = ground_.nest.moves().step(lane.cell, direction);
  if (lane.place[target] == 0) {
    enter<true>(lane, direction);
    return Outcome::goes_on;
  }
  while (lane.length + 1 > lane.place[target]) {
    lane.place[lane.cell] = 0;
    const std::uint8_t last = lane.directions[--lane.length];
    lane.cell = static_cast<std::uint32_t>(ground_.nest.moves().step(lane.cell, opposite(last)));
  }
  return Outcome::goes_on;
}

}  // namespace pathrace::algorithms
