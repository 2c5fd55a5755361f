#include "baselines/grid/jump_point_search.hpp"

#include <algorithm>
#include <bit>
#include <cstdlib>

#include "core/checkpoint.hpp"

namespace pathrace::baselines {
namespace {

// A jump point in a wide hall may take a millisecond.
constexpr std::uint64_t jump_point_clock_interval = 128;

constexpr RingCost unbounded = std::numeric_limits<RingCost>::max();

std::uint32_t pack(Cell cell) {
  return (static_cast<std::uint32_t>(cell.y) << 16) + static_cast<std::uint32_t>(cell.x);
}
Cell unpack(std::uint32_t entry) {
  return {static_cast<int>(entry & 0xFFFF), static_cast<int>(entry >> 16)};
}

// A jump is at most one march and one run; f rises by no more than twice its cost.
template <typename Ring>
RingCost greatest_rise(const OccupancyGrid& grid) {
  return 2 * Ring::diagonal * static_cast<RingCost>(grid.width() + grid.height());
}

// The two directions of the runs that begin on a march.
template <int direction>
constexpr std::array<int, 2> sides() {
  constexpr int angle = is_diagonal(direction) ? 1 : 2;
  return {(direction + angle) & 7, (direction - angle) & 7};
}

template <int direction>
constexpr unsigned natural_mask() {
  return 1U << direction | 1U << sides<direction>()[0] | 1U << sides<direction>()[1];
}

constexpr int sign(int value) {
  return (value > 0) - (value < 0);
}

}  // namespace

template <typename Ring>
JumpPointSearch<Ring>::JumpPointSearch(const Terrain& terrain)
    : grid_(*terrain.grid),
      rule_(terrain.rule),
      moves_(CanonicalMoves::of(terrain.rule)),
      neighbours_(free_neighbours(grid_)),
      jumps_(grid_, moves_, neighbours_),
      nodes_(grid_.padded_size()),
      parents_(filled_gradually<std::vector<std::uint32_t>>(grid_.padded_size(), 0)),
      open_(greatest_rise<Ring>(grid_)),
      stride_(static_cast<std::ptrdiff_t>(grid_.stride())) {}

template <typename Ring>
Answer JumpPointSearch<Ring>::plan(Cell start, Cell goal, Context& context) {
  if (context.meter.exhausted()) return std::nullopt;
  const Outcome outcome = search(start, goal, context.meter);
  report(outcome, expanded_, context.meter);
  if (outcome != Outcome::found) return std::nullopt;
  context.meter.improved(lattice_length<Ring>(nodes_.cost(target_)).value());
  return extract(start, goal);
}

template <typename Ring>
RingCost JumpPointSearch<Ring>::estimate(Cell cell) const {
  const int dx = goal_.x - cell.x;
  const int dy = goal_.y - cell.y;
  return rule_ == MoveRule::four ? ManhattanDistance<Ring>{}(dx, dy) : OctileDistance<Ring>{}(dx, dy);
}

template <typename Ring>
bool JumpPointSearch<Ring>::admit(const Meter& meter) {
  if (expanded_ == limit_) return false;
  return ++expanded_ % jump_point_clock_interval != 0 || !meter.out_of_time();
}

template <typename Ring>
Outcome JumpPointSearch<Ring>::search(Cell start, Cell goal, const Meter& meter) {
  goal_ = goal;
  target_ = grid_.index(goal);
  bound_ = unbounded;
  expanded_ = 0;
  limit_ = meter.checks_left();
  const Place first{start, grid_.index(start), 0};
  nodes_.restart();
  nodes_.reach(first.index, 0, 0);
  if (start == goal) return Outcome::found;
  if (!admit(meter)) return Outcome::cut;
  const JumpMap::Flag flag(jumps_, goal);
  nodes_.mark_expanded(first.index);
  open_.restart(estimate(start));
  expand(first, moves_.legal(neighbours_[first.index]));
  return run(meter);
}

// Over when no entry is left that could lead to a shorter path than the best.
template <typename Ring>
Outcome JumpPointSearch<Ring>::run(const Meter& meter) {
  while (!open_.empty()) {
    const Cell cell = unpack(open_.pop());
    if (open_.floor() >= bound_) break;
    const Place at{cell, grid_.index(cell), nodes_.cost(grid_.index(cell))};
    if (nodes_.expanded(at.index) || at.cost + estimate(cell) >= bound_) continue;
    if (!admit(meter)) return Outcome::cut;
    nodes_.mark_expanded(at.index);
    expand(at, moves_.after(nodes_.direction(at.index), neighbours_[at.index]));
  }
  return bound_ == unbounded ? Outcome::no_way : Outcome::found;
}

template <typename Ring>
void JumpPointSearch<Ring>::expand(const Place& from, unsigned mask) {
  parent_ = pack(from.cell);
  const bool four = rule_ == MoveRule::four;
  for (; mask != 0; mask &= mask - 1) {
    switch (std::countr_zero(mask)) {
      case 0: four ? march<0>(from) : run_straight<0>(from); break;
      case 1: march<1>(from); break;
      case 2: run_straight<2>(from); break;
      case 3: march<3>(from); break;
      case 4: four ? march<4>(from) : run_straight<4>(from); break;
      case 5: march<5>(from); break;
      case 6: run_straight<6>(from); break;
      case 7: march<7>(from); break;
      default: break;
    }
  }
}

template <typename Ring>
template <int direction>
typename JumpPointSearch<Ring>::Place JumpPointSearch<Ring>::moved(const Place& from, int steps) const {
  constexpr Cell step = directions[direction];
  return {
      {from.cell.x + steps * step.x, from.cell.y + steps * step.y},
      static_cast<std::size_t>(static_cast<std::ptrdiff_t>(from.index) + steps * (step.y * stride_ + step.x)),
      from.cost + static_cast<RingCost>(steps) * step_cost<Ring>(direction)};
}

template <typename Ring>
template <int direction>
void JumpPointSearch<Ring>::run_straight(const Place& from) {
  const Run run = jumps_.run<direction>(from.cell);
  if (run.at_jump_point) reach(moved<direction>(from, run.steps), direction);
}

// Expects that the first step is legal. A marched cell needs no parent: it is passed over, never a turn.
template <typename Ring>
template <int direction>
void JumpPointSearch<Ring>::march(Place at) {
  for (;;) {
    at = moved<direction>(at, 1);
    const unsigned mask = moves_.after(direction, neighbours_[at.index]);
    const bool turns = (mask & ~natural_mask<direction>()) != 0;
    if (turns || at.index == target_) return reach(at, direction);
    if (!nodes_.reach(at.index, at.cost, direction)) return;
    nodes_.mark_expanded(at.index);
    constexpr std::array<int, 2> side = sides<direction>();
    if ((mask >> side[0] & 1U) != 0) run_straight<side[0]>(at);
    if ((mask >> side[1] & 1U) != 0) run_straight<side[1]>(at);
    if ((mask >> direction & 1U) == 0) return;
  }
}

template <typename Ring>
void JumpPointSearch<Ring>::reach(const Place& at, int direction) {
  if (!nodes_.reach(at.index, at.cost, static_cast<unsigned>(direction))) return;
  const RingCost f = at.cost + estimate(at.cell);
  if (f >= bound_) return;
  parents_[at.index] = parent_;
  if (at.index == target_) {
    bound_ = at.cost;
  } else {
    open_.push(f, pack(at.cell));
  }
}

// Backwards: undoes a jump's straight part, then its diagonal part (under `four`: vertical, then horizontal).
template <typename Ring>
Path JumpPointSearch<Ring>::extract(Cell start, Cell goal) const {
  const LatticeLength length = lattice_length<Ring>(nodes_.cost(target_));
  Path path;
  path.points.resize(static_cast<std::size_t>(length.straight + length.diagonal) + 1);
  std::size_t i = path.points.size() - 1;
  path.points[i] = centre(goal);
  for (Cell cell = goal; cell != start;) {
    const Cell parent = unpack(parents_[grid_.index(cell)]);
    while (cell != parent) {
      const int dx = parent.x - cell.x;
      const int dy = parent.y - cell.y;
      const bool vertical = std::abs(dy) > (rule_ == MoveRule::four ? 0 : std::abs(dx));
      const bool horizontal = rule_ == MoveRule::four ? dy == 0 : std::abs(dx) > std::abs(dy);
      cell = {cell.x + (vertical ? 0 : sign(dx)), cell.y + (horizontal ? 0 : sign(dy))};
      path.points[--i] = centre(cell);
    }
  }
  return path;
}

template class JumpPointSearch<SmallRing>;
template class JumpPointSearch<LargeRing>;

}  // namespace pathrace::baselines
