// Best-first search on the grid: Dijkstra's algorithm and A*, by the heuristic.
//
// Steps are pruned to canonical ones (canonical_moves.hpp), so that an open map's cells are pushed about once
// each; costs are exact integers in a bucket queue, last in first out inside a bucket, which on equal f runs
// towards larger costs. Queue entries are packed coordinates. Nothing is allocated per query but the path,
// once the buckets have grown. 9 bytes per cell, and 4 per entry of the queue.
//
// E. W. Dijkstra, 1959; P. Hart, N. Nilsson, B. Raphael, "A Formal Basis for the Heuristic Determination of
// Minimum Cost Paths", IEEE Trans. SSC 4(2), 1968.
//
// Template header: the heuristic is inlined into the loop.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <type_traits>
#include <vector>

#include "baselines/grid/bucket_queue.hpp"
#include "baselines/grid/canonical_moves.hpp"
#include "baselines/grid/lattice_answer.hpp"
#include "baselines/grid/ring_cost.hpp"
#include "baselines/grid/search_nodes.hpp"
#include "core/lattice_length.hpp"
#include "core/planner.hpp"

namespace pathrace::baselines {

template <template <typename> typename Heuristic, typename Ring = SmallRing>
class GridSearch final : public MapPlanner {
 public:
  explicit GridSearch(const Terrain& terrain)
      : grid_(*terrain.grid),
        moves_(CanonicalMoves::of(terrain.rule)),
        neighbours_(free_neighbours(grid_)),
        nodes_(grid_.padded_size()) {
    const auto stride = static_cast<std::ptrdiff_t>(grid_.stride());
    for (std::size_t d = 0; d < steps_.size(); ++d) {
      const Cell step = directions[d];
      steps_[d] = {step.y * stride + step.x, pack(step), step_cost<Ring>(static_cast<int>(d))};
    }
  }

  /// One evaluation (the path found), one iteration; a check is a cell expanded.
  Answer plan(Cell start, Cell goal, Context& context) override {
    if (context.meter.exhausted()) return std::nullopt;
    const Outcome outcome = search(start, goal, context.meter);
    report(outcome, expanded_, context.meter);
    if (outcome != Outcome::found) return std::nullopt;
    context.meter.improved(distance(goal)->value());
    return extract(goal);
  }

  /// Expands every cell that can be reached from `start`.
  void flood(Cell start) requires(std::is_same_v<Heuristic<Ring>, ZeroDistance<Ring>>) {
    search(start, std::nullopt, Meter(Budget{}));
  }

  /// The least length from the start of the last flood, or of a search that came this far; nothing for other
  /// cells. The cell lies on the map.
  std::optional<LatticeLength> distance(Cell cell) const {
    const std::size_t index = grid_.index(cell);
    if (!nodes_.seen(index)) return std::nullopt;
    return lattice_length<Ring>(nodes_.cost(index));
  }

 private:
  static constexpr std::size_t nowhere = std::numeric_limits<std::size_t>::max();

  struct Step {
    std::ptrdiff_t index;  // what it adds to a padded index,
    std::uint32_t entry;   // to a queue entry, modulo 2^32,
    RingCost cost;         // and to the cost
  };

  static std::uint32_t pack(Cell cell) {
    return (static_cast<std::uint32_t>(cell.y) << 16) + static_cast<std::uint32_t>(cell.x);
  }
  static Cell unpack(std::uint32_t entry) {
    return {static_cast<int>(entry & 0xFFFF), static_cast<int>(entry >> 16)};
  }

  RingCost estimate(Cell cell) const { return heuristic_(goal_.x - cell.x, goal_.y - cell.y); }

  Outcome search(Cell start, std::optional<Cell> goal, const Meter& meter) {
    goal_ = goal.value_or(start);
    expanded_ = 0;
    limit_ = meter.checks_left();
    const std::size_t first = grid_.index(start);
    nodes_.restart();
    nodes_.reach(first, 0, 0);
    open_.restart(estimate(start));
    if (start == goal) return Outcome::found;
    if (!admit(meter)) return Outcome::cut;
    nodes_.mark_expanded(first);
    try_steps(moves_.legal(neighbours_[first]), pack(start), first, 0);
    return run(goal ? grid_.index(*goal) : nowhere, meter);
  }

  bool admit(const Meter& meter) {
    if (expanded_ == limit_) return false;
    return ++expanded_ % clock_interval != 0 || !meter.out_of_time();
  }

  // The goal is certain once the bucket it was popped from is empty: until then a cell of that bucket with a
  // smaller f might still improve it, so only those are expanded.
  Outcome run(std::size_t target, const Meter& meter) {
    bool found = false;
    while (!found && open_.advance()) {
      while (open_.current_bucket_has_more()) {
        const std::uint32_t entry = open_.pop();
        const Cell cell = unpack(entry);
        const std::size_t index = grid_.index(cell);
        if (nodes_.expanded(index)) continue;
        const RingCost cost = nodes_.cost(index);
        if (found && cost + estimate(cell) >= nodes_.cost(target)) continue;
        nodes_.mark_expanded(index);
        if (index == target) {
          found = true;
          continue;
        }
        if (!admit(meter)) return Outcome::cut;
        try_steps(moves_.after(nodes_.direction(index), neighbours_[index]), entry, index, cost);
      }
    }
    return found ? Outcome::found : Outcome::no_way;
  }

  void try_steps(unsigned mask, std::uint32_t entry, std::size_t index, RingCost cost) {
    for (; mask != 0; mask &= mask - 1) {
      const auto direction = static_cast<unsigned>(std::countr_zero(mask));
      const Step& step = steps_[direction];
      const std::size_t next = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(index) + step.index);
      const RingCost next_cost = cost + step.cost;
      if (!nodes_.reach(next, next_cost, direction)) continue;
      const std::uint32_t next_entry = entry + step.entry;
      open_.push(next_cost + estimate(unpack(next_entry)), next_entry);
    }
  }

  Path extract(Cell goal) const {
    const LatticeLength length = *distance(goal);
    Path path;
    path.points.resize(static_cast<std::size_t>(length.straight + length.diagonal) + 1);
    std::size_t index = grid_.index(goal);
    Cell cell = goal;
    for (std::size_t i = path.points.size() - 1; i > 0; --i) {
      path.points[i] = centre(cell);
      const unsigned direction = nodes_.direction(index);
      cell = {cell.x - directions[direction].x, cell.y - directions[direction].y};
      index = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(index) - steps_[direction].index);
    }
    path.points.front() = centre(cell);
    return path;
  }

  const OccupancyGrid& grid_;
  const CanonicalMoves& moves_;
  std::vector<std::uint8_t> neighbours_;
  SearchNodes<Ring> nodes_;
  std::array<Step, direction_count> steps_{};
  BucketQueue<Ring> open_;
  Heuristic<Ring> heuristic_;
  Cell goal_;
  std::uint64_t expanded_ = 0;
  std::uint64_t limit_ = 0;
};

/// On a map of any size.
template <template <typename> typename Heuristic>
std::unique_ptr<MapPlanner> grid_search(const Terrain& terrain) {
  if (fits_small_ring(*terrain.grid)) return std::make_unique<GridSearch<Heuristic>>(terrain);
  return std::make_unique<GridSearch<Heuristic, LargeRing>>(terrain);
}

}  // namespace pathrace::baselines
