// Best-first search on the grid: Dijkstra's algorithm and A*, by the heuristic.
//
// One 8-byte node per padded cell: 48 bits of cost, 12 bits of generation, one bit "expanded", 3 bits for the
// direction of the step that led here. A generation number makes a new query cost nothing: nodes of older
// generations count as unseen. Queue entries are packed coordinates. Nothing is allocated per query once the
// buckets have grown.
//
// E. W. Dijkstra, 1959; P. Hart, N. Nilsson, B. Raphael, "A Formal Basis for the Heuristic Determination of
// Minimum Cost Paths", IEEE Trans. SSC 4(2), 1968.
//
// Template header: the heuristic is inlined into the loop.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

#include "baselines/grid/bucket_queue.hpp"
#include "baselines/grid/ring_cost.hpp"
#include "core/lattice_length.hpp"
#include "core/moves.hpp"
#include "core/planner.hpp"

namespace pathrace::baselines {

template <typename Heuristic>
class GridSearch final : public MapPlanner {
 public:
  explicit GridSearch(const Terrain& terrain)
      : grid_(*terrain.grid), moves_(grid_, terrain.rule), nodes_(grid_.padded_size(), 0) {}

  /// One evaluation (the path found), one iteration; a check is a cell expanded.
  Answer plan(Cell start, Cell goal, Context& context) override {
    if (context.meter.exhausted()) return std::nullopt;
    begin_query(start, goal);
    const Outcome outcome = search(goal, context.meter);
    context.meter.spend_checks(expanded_);
    if (outcome == Outcome::cut) return std::nullopt;
    context.meter.end_iteration();
    if (outcome == Outcome::no_way) {
      context.meter.conclude();
      return std::nullopt;
    }
    context.meter.spend_evaluations(1);
    LatticeLength length;
    Path path = extract(start, goal, length);
    context.meter.improved(length.value());
    return path;
  }

 private:
  static constexpr int cost_shift = 16;
  static constexpr std::uint64_t generation_mask = 0xFFF;
  static constexpr std::uint64_t expanded_bit = 8;
  static constexpr std::uint64_t direction_mask = 7;
  static constexpr std::uint64_t clock_interval = 4096;

  enum class Outcome { found, no_way, cut };

  static RingCost cost_of(std::uint64_t node) { return node >> cost_shift; }
  std::uint64_t pack(RingCost cost, std::uint64_t direction) const {
    return cost << cost_shift | generation_ << 4 | direction;
  }
  bool seen(std::uint64_t node) const { return (node >> 4 & generation_mask) == generation_; }

  static std::uint32_t entry(Cell cell) {
    return static_cast<std::uint32_t>(cell.y) << 16 | static_cast<std::uint32_t>(cell.x);
  }
  static Cell cell_of(std::uint32_t entry) {
    return {static_cast<int>(entry & 0xFFFF), static_cast<int>(entry >> 16)};
  }

  RingCost estimate(Cell cell, Cell goal) const { return heuristic_(goal.x - cell.x, goal.y - cell.y); }

  void begin_query(Cell start, Cell goal) {
    if (generation_ == generation_mask) {
      std::fill(nodes_.begin(), nodes_.end(), 0);
      generation_ = 0;
    }
    ++generation_;
    expanded_ = 0;
    nodes_[grid_.index(start)] = pack(0, 0);
    open_.restart(estimate(start, goal));
    open_.push(estimate(start, goal), entry(start));
  }

  // The goal is certain once the bucket it was popped from is empty: until then a cell of that bucket with a
  // smaller f might still improve it, so only those are expanded.
  Outcome search(Cell goal, const Meter& meter) {
    const std::size_t target = grid_.index(goal);
    const std::uint64_t limit = meter.checks_left();
    bool found = false;
    while (!open_.empty() && !(found && !open_.current_bucket_has_more())) {
      const Cell cell = cell_of(open_.pop());
      const std::size_t index = grid_.index(cell);
      const std::uint64_t node = nodes_[index];
      if ((node & expanded_bit) != 0) continue;
      if (found && cost_of(node) + estimate(cell, goal) >= cost_of(nodes_[target])) continue;
      nodes_[index] = node | expanded_bit;
      if (index == target) {
        found = true;
        continue;
      }
      if (expanded_ == limit) return Outcome::cut;
      if (++expanded_ % clock_interval == 0 && meter.out_of_time()) return Outcome::cut;
      expand(cell, index, cost_of(node), goal);
    }
    return found ? Outcome::found : Outcome::no_way;
  }

  void expand(Cell cell, std::size_t index, RingCost cost, Cell goal) {
    for (unsigned mask = moves_[index]; mask != 0; mask &= mask - 1) {
      const int direction = std::countr_zero(mask);
      const std::size_t next = moves_.step(index, direction);
      const RingCost next_cost = cost + step_cost(direction);
      const std::uint64_t known = nodes_[next];
      if (seen(known) && cost_of(known) <= next_cost) continue;
      nodes_[next] = pack(next_cost, static_cast<std::uint64_t>(direction));
      const Cell step = directions[static_cast<std::size_t>(direction)];
      const Cell there{cell.x + step.x, cell.y + step.y};
      open_.push(next_cost + estimate(there, goal), entry(there));
    }
  }

  Path extract(Cell start, Cell goal, LatticeLength& length) const {
    Path path;
    Cell cell = goal;
    path.points.push_back(centre(cell));
    while (cell != start) {
      const auto direction = static_cast<std::size_t>(nodes_[grid_.index(cell)] & direction_mask);
      (is_diagonal(static_cast<int>(direction)) ? length.diagonal : length.straight) += 1;
      cell = {cell.x - directions[direction].x, cell.y - directions[direction].y};
      path.points.push_back(centre(cell));
    }
    std::reverse(path.points.begin(), path.points.end());
    return path;
  }

  const OccupancyGrid& grid_;
  MoveTable moves_;
  std::vector<std::uint64_t> nodes_;
  BucketQueue open_;
  Heuristic heuristic_;
  std::uint64_t generation_ = 0;
  std::uint64_t expanded_ = 0;
};

}  // namespace pathrace::baselines
