#include "baselines/incremental/d_star_lite.hpp"

#include <algorithm>
#include <bit>
#include <utility>

namespace pathrace::baselines {
namespace {

constexpr OctileDistance<> estimate;  // under `four` a lower bound still

RingCost between(Cell a, Cell b) {
  return estimate(a.x - b.x, a.y - b.y);
}

}  // namespace

DStarLite::DStarLite(const Terrain& terrain, TieRule ties)
    : ties_(ties), map_(terrain), nodes_(terrain.grid->padded_size()), queue_(terrain.grid->padded_size()) {
  const auto stride = static_cast<std::ptrdiff_t>(terrain.grid->stride());
  for (std::size_t d = 0; d < offsets_.size(); ++d) offsets_[d] = directions[d].y * stride + directions[d].x;
  for (int y = 0; y < terrain.grid->height(); ++y) {
    for (int x = 0; x < terrain.grid->width(); ++x) {
      Node& node = nodes_[terrain.grid->index({x, y})];
      node.x = static_cast<std::int16_t>(x);
      node.y = static_cast<std::int16_t>(y);
    }
  }
}

Outcome DStarLite::search(const OccupancyGrid& grid, Cell robot, Cell goal, const Meter& meter) {
  look(grid, robot, goal);
  expanded_ = 0;
  limit_ = meter.checks_left();
  if (map_.steps(robot_index_) == 0 && robot != goal) return Outcome::no_way;
  while (!is_settled()) {
    const auto [key, cell] = queue_.top();
    const SearchKey present = key_of(nodes_[cell]);
    if (key < present) {  // it was made for an earlier place of the robot
      queue_.put(cell, present);
      continue;
    }
    if (!admit(meter)) return Outcome::cut;
    expand(cell);
  }
  return nodes_[robot_index_].rhs == never ? Outcome::no_way : Outcome::found;
}

// What has changed since the last search.
void DStarLite::look(const OccupancyGrid& grid, Cell robot, Cell goal) {
  const std::vector<std::uint32_t>& changed = map_.look(grid);
  const Cell before = std::exchange(robot_, robot);
  robot_index_ = static_cast<Index>(grid.index(robot));
  restarted_ = goal != goal_;
  if (restarted_) {
    restart(goal, static_cast<Index>(grid.index(goal)));
    return;
  }
  moved_ += between(before, robot);
  for (const Index cell : changed) {
    if (cell == goal_index_) continue;
    const RingCost said = std::exchange(nodes_[cell].rhs, rhs_of(cell));
    if (nodes_[cell].rhs != said) update(cell);
  }
}

void DStarLite::restart(Cell goal, Index index) {
  for (Node& node : nodes_) node.g = node.rhs = never;
  queue_.clear();
  moved_ = 0;
  goal_ = goal;
  goal_index_ = index;
  nodes_[index].rhs = 0;
  update(index);
}

// Among cells of one estimate, the paper's second part is min(g, rhs). What it is needed for is that a cell
// whose g is too small comes before all that build upon it; the other rule sees to that by itself.
SearchKey DStarLite::key_of(const Node& node) const {
  const RingCost least = std::min(node.g, node.rhs);
  const RingCost first = least + between({node.x, node.y}, robot_) + moved_;
  if (ties_ == TieRule::paper) return {first, least};
  return {first, node.g < node.rhs ? 0 : 1 + never - node.rhs};
}

// What is not below this cannot matter to the robot.
SearchKey DStarLite::bound() const {
  const Node& node = nodes_[robot_index_];
  const RingCost least = std::min(node.g, node.rhs);
  return {least + moved_, ties_ == TieRule::paper ? least : 1};
}

bool DStarLite::is_settled() const {
  const Node& node = nodes_[robot_index_];
  return queue_.empty() || (!(queue_.top().key < bound()) && node.rhs <= node.g);
}

bool DStarLite::admit(const Meter& meter) {
  if (expanded_ == limit_) return false;
  return ++expanded_ % clock_interval != 0 || !meter.out_of_time();
}

void DStarLite::expand(Index cell) {
  if (nodes_[cell].g > nodes_[cell].rhs) {
    lower(cell);
  } else {
    raise(cell);
  }
}

// The distance is what the neighbours say; they may gain by it.
void DStarLite::lower(Index cell) {
  const RingCost g = nodes_[cell].g = nodes_[cell].rhs;
  queue_.remove(cell);
  for (unsigned mask = map_.steps(cell); mask != 0; mask &= mask - 1) {
    const Step from = step(cell, static_cast<unsigned>(std::countr_zero(mask)));
    Node& node = nodes_[from.cell];
    if (g + from.cost >= node.rhs) continue;
    node.rhs = g + from.cost;
    update(from.cell);
  }
}

// The distance was too small; so is that of all who came this way, among whom the goal never is: its rhs is
// 0.
void DStarLite::raise(Index cell) {
  const RingCost before = std::exchange(nodes_[cell].g, never);
  update(cell);
  for (unsigned mask = map_.steps(cell); mask != 0; mask &= mask - 1) {
    const Step from = step(cell, static_cast<unsigned>(std::countr_zero(mask)));
    if (nodes_[from.cell].rhs != before + from.cost) continue;
    nodes_[from.cell].rhs = rhs_of(from.cell);
    update(from.cell);
  }
}

RingCost DStarLite::rhs_of(Index cell) const {
  RingCost least = never;
  for (unsigned mask = map_.steps(cell); mask != 0; mask &= mask - 1) {
    const Step to = step(cell, static_cast<unsigned>(std::countr_zero(mask)));
    least = std::min(least, to.cost + nodes_[to.cell].g);
  }
  return least;
}

void DStarLite::update(Index cell) {
  const Node& node = nodes_[cell];
  if (node.g == node.rhs) {
    queue_.remove(cell);
  } else {
    queue_.put(cell, key_of(node));
  }
}

DStarLite::Step DStarLite::step(Index cell, unsigned direction) const {
  return {static_cast<Index>(static_cast<std::ptrdiff_t>(cell) + offsets_[direction]),
          step_cost(static_cast<int>(direction))};
}

std::optional<LatticeLength> DStarLite::distance() const {
  const RingCost cost = nodes_[robot_index_].rhs;
  if (cost == never) return std::nullopt;
  return lattice_length(cost);
}

// Always to the neighbour through which the goal is nearest.
Path DStarLite::path() const {
  std::vector<Cell> cells{robot_};
  for (Index cell = robot_index_; cell != goal_index_; cells.push_back(place(cell))) cell = best_step(cell);
  return lattice_path(cells);
}

// Of several, the first diagonal one, as A* with its canonical orderings prefers; else the first.
DStarLite::Index DStarLite::best_step(Index cell) const {
  Step best{cell, never};
  for (const unsigned kind : {0xAAU, 0x55U}) {
    for (unsigned mask = map_.steps(cell) & kind; mask != 0; mask &= mask - 1) {
      const Step to = step(cell, static_cast<unsigned>(std::countr_zero(mask)));
      const RingCost cost = to.cost + nodes_[to.cell].g;
      if (cost < best.cost) best = {to.cell, cost};
    }
  }
  return best.cell;
}

}  // namespace pathrace::baselines
