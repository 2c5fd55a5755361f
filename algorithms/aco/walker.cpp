#include "algorithms/aco/walker.hpp"

#include <algorithm>
#include <bit>
#include <span>

#include "algorithms/aco/choice.hpp"
#include "core/checkpoint.hpp"
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

Walker::Terms::Terms(const Ground& ground, const TrailRow* trail_rows, const FirstOffsets& first)
    : rows(trail_rows),
      first_offsets(first.data()),
      stride(static_cast<std::ptrdiff_t>(ground.nest.stride())),
      goal(static_cast<std::uint32_t>(ground.nest.goal())),
      least_strength(ground.trail.least_strength()),
      q0(static_cast<float>(ground.q0)) {
  for (int d = 0; d < direction_count; ++d) {
    offsets[static_cast<std::size_t>(d)] = static_cast<std::int32_t>(ground.nest.moves().offset(d));
  }
}

Walker::Walker(const Ground& ground, std::size_t lanes) : ground_(ground), lanes_(lanes) {
  for (unsigned mask = 1; mask < first_offsets_.size(); ++mask) {
    first_offsets_[mask] = static_cast<std::int32_t>(ground.nest.moves().offset(std::countr_zero(mask)));
  }
  const std::size_t margin = ground.nest.stride() + 4;
  for (Lane& lane : lanes_) {
    assign_gradually(lane.mark_bytes, ground.nest.size() + 2 * margin, std::uint8_t{0});
    lane.marks = lane.mark_bytes.data() + margin;
    assign_gradually(lane.path_bytes, ground.nest.free_cells() + 2, std::uint8_t{0});
    lane.first = lane.path_bytes.data() + 1;
    if (ground.dead_end == DeadEnd::revisit_with_loop_erasure) {
      assign_gradually(lane.place, ground.nest.size(), std::uint32_t{0});
    }
  }
}

std::size_t Walker::run(AntQueue& ants, const Outing& outing, EarlyDeposits* deposits) {
  outing_ = &outing;
  deposits_ = deposits;
  limit_ = std::min(outing.step_limit, ground_.max_steps);
  paths_.resize(outing.walks.size());
  const bool far = is_far(ground_.nest.size());
  const auto run = [&]<bool greedy, bool with_places, bool backs_up>() {
    return far ? run_lanes<Gait{greedy, with_places, backs_up, true}>(ants)
               : run_lanes<Gait{greedy, with_places, backs_up, false}>(ants);
  };
  const auto run_by_policy = [&]<bool greedy>() {
    if (ground_.dead_end == DeadEnd::revisit_with_loop_erasure) return run.operator()<greedy, true, false>();
    const bool plainly = ground_.trail.every_step_weighs() && !ground_.keep_popped;
    if (ground_.dead_end == DeadEnd::backtrack && plainly) return run.operator()<greedy, false, true>();
    return run.operator()<greedy, false, false>();
  };
  return ground_.q0 > 0 ? run_by_policy.operator()<true>() : run_by_policy.operator()<false>();
}

template <Walker::Gait gait>
std::size_t Walker::run_lanes(AntQueue& ants) {
  const TrailRow* const rows = deposits_ != nullptr ? ground_.trail.rows() : ground_.trail.rows_for_others();
  std::size_t under_way = 0;
  while (under_way < lanes_.size()) {
    const std::size_t ant = ants.take();
    if (ant == AntQueue::none) break;
    begin(under_way++, ant);
  }
  std::size_t taken_over = 0;
  do {
    if (under_way > 1) under_way = walk_side_by_side<gait>(ants, under_way, rows);
    if (under_way == 1) walk_one_by_one<gait>(ants, rows);
    under_way = hand_over_.ask();
    taken_over += under_way;
  } while (under_way > 0);
  return taken_over;
}

// To the last, or until the last has been given away. Returns how many are left.
template <Walker::Gait gait>
std::size_t Walker::walk_side_by_side(AntQueue& ants, std::size_t under_way, const TrailRow* rows) {
  const Terms terms(ground_, rows, first_offsets_);
  const HandOver::Open open(hand_over_);
  std::size_t due = lanes_.size();  // so many have to be back for deposits to go on; one at the end
  std::size_t back = 0;             // since deposits went on last
  while (under_way > 1) {
    draws_.advance(under_way);
    for (std::size_t k = 0; k < under_way;) {
      const Outcome outcome = step<gait>(k, terms);
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
    if (hand_over_.is_asked()) under_way = give(under_way);
  }
  return under_way;
}

template <Walker::Gait gait>
void Walker::walk_one_by_one(AntQueue& ants, const TrailRow* rows) {
  while (true) {
    Outcome outcome = Outcome::goes_on;
    while (outcome == Outcome::goes_on) outcome = walk_alone<gait>(rows);
    finish(lanes_[0], outcome == Outcome::arrived);
    if (deposits_ != nullptr) deposits_->go_on();
    const std::size_t ant = ants.take();
    if (ant == AntQueue::none) return;
    begin(0, ant);
  }
}

std::size_t Walker::give(std::size_t under_way) {
  const std::size_t given = hand_over_.answer([&](Walker& asking) {
    const std::size_t count = under_way / 2;
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t last = under_way - 1 - k;
      std::swap(asking.lanes_[k], lanes_[last]);
      asking.draws_.take(draws_, last, k);
    }
    return count;
  });
  return under_way - given;
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
  update(walk.pops, lane.pops());
  const std::span<const std::uint8_t> path(lane.first, arrived || ground_.keep_the_dead ? lane.length() : 0);
  if (!std::equal(path.begin(), path.end(), walk.directions.begin(), walk.directions.end())) {
    walk.directions.assign(path.begin(), path.end());
  }
  paths_[lane.ant] = walk.directions.data();
  update(walk.length, length_of(walk.directions));
  if (ground_.count_turns) update(walk.turns, turns_of(walk.directions));
  if (ground_.keep_popped && (lane.pops() > 0 || !walk.popped.empty())) walk.popped = lane.popped;
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

template <Walker::Gait gait>
Walker::Outcome Walker::step(std::size_t k, const Terms& terms) {
  Lane& lane = lanes_[k];
  if (lane.left == 0 && !may_go_on(lane)) return Outcome::died;
  --lane.left;
  const Turn turn = turn_at<gait>(lane, draws_.bits(k), terms);
  if (!gait.backs_up && turn.direction == no_choice) return stuck(k);
  return take<gait>(lane, lane.place.data(), turn, terms);
}

// The last ant under way has the processor to itself, which waits for the end of a step before it can begin
// the next. So where an ant is stays in registers, and where it goes is found in fewer instructions one after
// the other, if in more altogether.
template <Walker::Gait gait>
Walker::Outcome Walker::walk_alone(const TrailRow* rows) {
  constexpr Gait alone{gait.greedy, gait.with_places, gait.backs_up, false};  // there is no time ahead
  Lane& lane = lanes_[0];
  if (lane.left == 0 && !may_go_on(lane)) return Outcome::died;
  const Terms terms(ground_, rows, first_offsets_);
  std::uint32_t* const place = lane.place.data();
  Foot foot = static_cast<Foot&>(lane);
  bool is_stuck = false;
  Outcome outcome = Outcome::goes_on;
  while (outcome == Outcome::goes_on && !is_stuck && foot.left > 0) {
    --foot.left;
    draws_.advance(1);
    const Turn turn = turn_soon<alone>(foot, draws_.bits(0), terms);
    is_stuck = !gait.backs_up && turn.direction == no_choice;
    if (!is_stuck) outcome = take<alone>(foot, place, turn, terms);
  }
  static_cast<Foot&>(lane) = foot;
  return is_stuck ? stuck(0) : outcome;
}

ChoicePoint Walker::choice_point(const Foot& foot, const Terms& terms) {
  return {terms.rows + foot.cell, foot.marks + foot.cell, terms.stride, foot.mark,
          foot.recent.closed(),   terms.least_strength};
}

template <Walker::Gait gait>
Walker::Turn Walker::turn_at(const Foot& foot, std::uint64_t bits, const Terms& terms) {
  const ChoicePoint at = choice_point(foot, terms);
  const int choice = gait.greedy ? choose(at, bits, terms.q0) : choose(at, bits);
  if (!gait.backs_up) return {choice, 0, foot.cell + terms.offset(choice & 7)};
  const int back = choice / no_choice;
  const int direction = (choice & 7) | (opposite(foot.next[-1]) & -back);
  return {direction, back, foot.cell + terms.offset(direction)};
}

template <Walker::Gait gait>
Walker::Turn Walker::turn_soon(const Foot& foot, std::uint64_t bits, const Terms& terms) {
  if (gait.greedy) return turn_at<gait>(foot, bits, terms);
  const unsigned choices = choose_soon(choice_point(foot, terms), bits);
  const int choice = first_of(choices);
  if (!gait.backs_up) return {choice, 0, foot.cell + terms.first_offset(choices)};
  const int back = choices == 0 ? 1 : 0;
  const int way_back = opposite(foot.next[-1]);
  const std::uint32_t base = foot.cell + (terms.offset(way_back) & static_cast<std::uint32_t>(-back));
  return {(choice & 7) | (way_back & -back), back, base + terms.first_offset(choices)};
}

template <Walker::Gait gait>
Walker::Outcome Walker::take(Foot& foot, std::uint32_t* place, const Turn& turn, const Terms& terms) {
  const bool all_is_seen = gait.backs_up && foot.next - turn.back < foot.first;
  if (all_is_seen) return Outcome::died;
  const std::uint32_t cell = foot.cell;
  foot.marks[foot.further] = foot.mark;
  foot.further = foot.behind;
  foot.behind = cell;
  foot.cell = turn.target;
  foot.recent.add(turn.direction);
  *foot.next = static_cast<std::uint8_t>(turn.direction);
  foot.next += 1 - 2 * turn.back;
  if (gait.with_places) place[turn.target] = static_cast<std::uint32_t>(foot.length() + 1);
  if (gait.far) fetch(foot, terms.rows + turn.target, terms.stride);
  return turn.target == terms.goal ? Outcome::arrived : Outcome::goes_on;
}

}  // namespace pathrace::algorithms
