// D* Lite: a shortest path from a robot that moves to a goal, on a map that changes, found by repairing the
// last search.
//
// The search runs backwards from the goal. A cell has g, its distance to the goal as last settled, and rhs,
// the distance that its neighbours' g give; cells where the two differ are in the queue. A change of the map
// changes the rhs of the cells whose steps it touched, and only what follows from that is expanded again.
// While the robot moves, keys in the queue stay lower bounds, since those made later are raised by k_m, the
// way that the robot has moved, by the heuristic.
//
// This is the optimized version (the paper's Figure 4), with three things of our own. Costs are exact
// integers (ring_cost.hpp), so equal costs are equal. A robot without a legal step has no way, and none is
// looked for: a search from the goal would expand all that the goal can reach. And a goal that leaves its
// cell starts the search anew; to repair it with a moved root, which is right as well, expanded 1.3 times as
// many cells over 120 worlds of discs, since every g is a distance to the goal. Nothing is allocated after
// the first call but the path.
//
// S. Koenig, M. Likhachev, "D* Lite", AAAI 2002.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "baselines/grid/lattice_answer.hpp"
#include "baselines/grid/ring_cost.hpp"
#include "baselines/incremental/changing_map.hpp"
#include "baselines/incremental/keyed_heap.hpp"
#include "baselines/incremental/tie_rule.hpp"
#include "core/path.hpp"

namespace pathrace::baselines {

class DStarLite {
 public:
  /// For maps of this terrain's sides and rule, the first of which is this one; it need not outlive the call.
  explicit DStarLite(const Terrain& terrain, TieRule ties = TieRule::paper);

  /// Looks at the map as it is now and settles the distance from robot to goal, both on free cells of it.
  /// `cut` when the meter's checks or time end first, one check per cell expanded; the next call goes on from
  /// there. Spends nothing itself.
  Outcome search(const OccupancyGrid& grid, Cell robot, Cell goal, const Meter& meter);

  /// The following are about the last search. Cells expanded:
  std::uint64_t expanded() const { return expanded_; }
  /// whether it began anew:
  bool restarted() const { return restarted_; }
  /// from robot to goal, where found:
  std::optional<LatticeLength> distance() const;
  Path path() const;

 private:
  using Index = KeyedHeap::Index;
  static constexpr RingCost never = RingCost{1} << 62;

  struct Node {
    RingCost g = never;
    RingCost rhs = never;
    std::int16_t x = 0;
    std::int16_t y = 0;
  };

  struct Step {
    Index cell;
    RingCost cost;
  };

  void look(const OccupancyGrid& grid, Cell robot, Cell goal);
  void restart(Cell goal, Index index);
  SearchKey key_of(const Node& node) const;
  SearchKey bound() const;
  bool is_settled() const;
  bool admit(const Meter& meter);
  void expand(Index cell);
  void lower(Index cell);
  void raise(Index cell);
  RingCost rhs_of(Index cell) const;
  void update(Index cell);
  Index best_step(Index cell) const;

  Step step(Index cell, unsigned direction) const;
  Cell place(Index cell) const { return {nodes_[cell].x, nodes_[cell].y}; }

  TieRule ties_;
  ChangingMap map_;
  std::array<std::ptrdiff_t, direction_count> offsets_{};
  std::vector<Node> nodes_;
  KeyedHeap queue_;
  Cell robot_;
  Cell goal_{-1, -1};
  Index robot_index_ = 0;
  Index goal_index_ = 0;
  RingCost moved_ = 0;  // k_m
  std::uint64_t expanded_ = 0;
  std::uint64_t limit_ = 0;
  bool restarted_ = false;
};

}  // namespace pathrace::baselines
