#include "algorithms/aco/walker.hpp"

#include <algorithm>
#include <span>

#include "algorithms/aco/choice.hpp"
#include "core/prefetch.hpp"

namespace pathrace::algorithms {
namespace {

// Writes nothing where that is the value already: a cache line that is not written stays with all who have
// read it.
template <typename T>
void update(T& kept, const T& value) {
  if (kept != value) kept = value;
}

}  // namespace

Walker::Terms::Terms(const Ground& ground, const TrailRow* trail_rows)
    : rows(trail_rows),
      stride(static_cast<std::ptrdiff_t>(ground.nest.stride())),
      goal(static_cast<std::uint32_t>(ground.nest.goal())),
      least_strength(ground.trail.least_strength()),
      q0(static_cast<float>(ground.q0)) {
  for (int d = 0; d < direction_count; ++d) {
    offsets[static_cast<std::size_t>(d)] = static_cast<std::int32_t>(ground.nest.moves().offset(d));
  }
}

Walker::Walker(const Ground& ground, std::size_t lanes) : ground_(ground), lanes_(lanes) {
  const std::size_t margin = ground.nest.stride() + 4;
  for (Lane& lane : lanes_) {
    lane.mark_bytes.resize(ground.nest.size() + 2 * margin);
    lane.marks = lane.mark_bytes.data() + margin;
    lane.path_bytes.resize(ground.nest.free_cells() + 2);
    lane.first = lane.path_bytes.data() + 1;
    if (ground.dead_end == DeadEnd::revisit_with_loop_erasure) lane.place.resize(ground.nest.size());
  }
}

void Walker::run(AntQueue& ants, const Outing& outing, EarlyDeposits* deposits) {
  outing_ = &outing;
  deposits_ = deposits;
  limit_ = std::min(outing.step_limit, ground_.max_steps);
  paths_.resize(outing.walks.size());
  const bool far = is_far(ground_.nest.size());
  const auto run = [&]<bool greedy, bool with_places, bool backs_up>() {
    far ? run_lanes<greedy, with_places, backs_up, true>(ants)
        : run_lanes<greedy, with_places, backs_up, false>(ants);
  };
  const auto run_by_policy = [&]<bool greedy>() {
    if (ground_.dead_end == DeadEnd::revisit_with_loop_erasure) return run.operator()<greedy, true, false>();
    const bool plainly = ground_.trail.every_step_weighs() && !ground_.keep_popped;
    if (ground_.dead_end == DeadEnd::backtrack && plainly) return run.operator()<greedy, false, true>();
    run.operator()<greedy, false, false>();
  };
  ground_.q0 > 0 ? run_by_policy.operator()<true>() : run_by_policy.operator()<false>();
}

template <bool greedy, bool with_places, bool backs_up, bool far>
void Walker::run_lanes(AntQueue& ants) {
  const Terms terms(ground_, deposits_ != nullptr ? ground_.trail.rows() : ground_.trail.rows_for_others());
  std::size_t under_way = 0;
  std::size_t due = lanes_.size();  // so many have to be back for deposits to go on; one at the end
  while (under_way < lanes_.size()) {
    const std::size_t ant = ants.take();
    if (ant == AntQueue::none) break;
    begin(under_way++, ant);
  }
  std::size_t back = 0;  // since deposits went on last
  while (under_way > 0) {
    draws_.advance(under_way);
    for (std::size_t k = 0; k < under_way;) {
      const Outcome outcome = step<greedy, with_places, backs_up, far>(k, terms);
      if (outcome != Outcome::goes_on) {
        finish(lanes_[k], outcome == Outcome::arrived);
        ++back;
        const std::size_t ant = ants.take();
        if (ant == AntQueue::none) {
          --under_way;
          due = 1;
          std::swap(lanes_[k], lanes_[under_way]);
          draws_.move(under_way, k);
          continue;  // with the lane that has come here
        }
        begin(k, ant);
      }
      ++k;
    }
    if (back >= due && deposits_ != nullptr) {
      deposits_->go_on();
      back = 0;
    }
  }
}

void Walker::begin(std::size_t k, std::size_t ant) {
  Lane& lane = lanes_[k];
  if (++lane.mark == 0) {
    std::fill(lane.mark_bytes.begin(), lane.mark_bytes.end(), std::uint8_t{0});
    lane.mark = 1;
  }
  lane.cell = lane.behind = lane.further = static_cast<std::uint32_t>(ground_.nest.start());
  lane.recent = {};
  lane.next = lane.first;
  lane.left = 0;
  lane.pause = 0;
  lane.pops = 0;
  draws_.set(k, outing_->stream.fork(ant));
  lane.ant = ant;
  prefetch(&outing_->walks[ant]);  // its last walk, which this one is compared with
  prefetch(paths_[ant]);
  lane.popped.clear();
  if (!lane.place.empty()) lane.place[lane.cell] = 1;
}

void Walker::finish(Lane& lane, bool arrived) {
  Walk& walk = outing_->walks[lane.ant];
  update(walk.arrived, arrived);
  update(walk.decisions, lane.decisions());
  update(walk.pops, lane.pops);
  const std::span<const std::uint8_t> path(lane.first, arrived || ground_.keep_the_dead ? lane.length() : 0);
  if (!std::equal(path.begin(), path.end(), walk.directions.begin(), walk.directions.end())) {
    walk.directions.assign(path.begin(), path.end());
  }
  paths_[lane.ant] = walk.directions.data();
  update(walk.length, length_of(walk.directions));
  if (ground_.count_turns) update(walk.turns, turns_of(walk.directions));
  if (ground_.keep_popped && (lane.pops > 0 || !walk.popped.empty())) walk.popped = lane.popped;
  if (outing_->roll_call != nullptr) outing_->roll_call->sign(lane.ant, outing_->round);
  if (lane.place.empty()) return;
  std::size_t cell = ground_.nest.start();
  lane.place[cell] = 0;
  for (const std::uint8_t* direction = lane.first; direction != lane.next; ++direction) {
    cell = ground_.nest.moves().step(cell, *direction);
    lane.place[cell] = 0;
  }
}

bool Walker::may_go_on(Lane& lane) const {
  const std::uint64_t decisions = lane.pause;
  if (decisions == limit_) return false;
  if (decisions > 0 && outing_->meter.out_of_time()) return false;
  lane.pause = std::min(limit_, decisions + clock_interval);
  lane.left = lane.pause - decisions;
  return true;
}

void Walker::fetch(const Lane& lane, const TrailRow* row, std::ptrdiff_t stride) {
  const std::uint8_t* marks = lane.marks + lane.cell;
  __builtin_prefetch(row);
  __builtin_prefetch(marks - stride);
  __builtin_prefetch(marks);
  __builtin_prefetch(marks + stride);
}

template <bool greedy, bool with_places, bool backs_up, bool far>
Walker::Outcome Walker::step(std::size_t k, const Terms& terms) {
  Lane& lane = lanes_[k];
  if (lane.left == 0 && !may_go_on(lane)) return Outcome::died;
  --lane.left;
  const std::uint32_t cell = lane.cell;
  const ChoicePoint at{terms.rows + cell, lane.marks + cell,    terms.stride,
                       lane.mark,         lane.recent.closed(), terms.least_strength};
  const std::uint64_t bits = draws_.bits(k);
  const int choice = greedy ? choose(at, bits, terms.q0) : choose(at, bits);
  if (!backs_up && choice == no_choice) return stuck(k);
  const int back = backs_up ? choice / no_choice : 0;
  if (backs_up && lane.next - back < lane.first) return Outcome::died;  // all that can be reached is seen
  const int direction = backs_up ? (choice & 7) | (opposite(lane.next[-1]) & -back) : choice;
  const std::uint32_t target =
      cell + static_cast<std::uint32_t>(terms.offsets[static_cast<std::size_t>(direction)]);
  lane.marks[lane.further] = lane.mark;
  lane.further = lane.behind;
  lane.behind = cell;
  lane.cell = target;
  lane.recent.add(direction);
  *lane.next = static_cast<std::uint8_t>(direction);
  lane.next += 1 - 2 * back;
  if (backs_up) lane.pops += static_cast<std::uint64_t>(back);
  if (with_places) lane.place[target] = static_cast<std::uint32_t>(lane.length() + 1);
  if (far) fetch(lane, terms.rows + target, terms.stride);
  return target == terms.goal ? Outcome::arrived : Outcome::goes_on;
}

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
  ++lane.pops;
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
