// Jump point search: A* over the cells where a canonical path may have to turn.
//
// From a cell, straight directions are run along to the first jump point or wall (jump_lines.hpp); diagonal
// ones are marched along cell by cell, with straight runs to both sides from each cell. A jump point is
// pushed with the cell it came from; cells on a diagonal where only its natural runs begin are passed over.
// From a node's parent to the node the way is diagonal first, then straight, so the parent is all that a path
// needs. Under the rule `four` horizontal marches and vertical runs take these parts.
//
// A marched cell keeps its cost, and a march that comes to a cell at no less cost ends there: whatever lies
// ahead was reached at no more. So marches from many jump points do not sweep an open hall again and again.
//
// D. Harabor, A. Grastien, "Online Graph Pruning for Pathfinding on Grid Maps", AAAI 2011; "Improving Jump
// Point Search", ICAPS 2014: block-based scanning (JPS(B)) and pruning of intermediate points (JPS(P)).
//
// 14 bytes per cell, and 8 per entry of the queue.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "baselines/grid/canonical_moves.hpp"
#include "baselines/grid/jump_lines.hpp"
#include "baselines/grid/lattice_answer.hpp"
#include "baselines/grid/ring_cost.hpp"
#include "baselines/grid/search_nodes.hpp"
#include "baselines/grid/wide_bucket_queue.hpp"
#include "core/planner.hpp"

namespace pathrace::baselines {

template <typename Ring = SmallRing>
class JumpPointSearch final : public MapPlanner {
 public:
  explicit JumpPointSearch(const Terrain& terrain);

  /// One evaluation (the path found), one iteration; a check is a jump point expanded.
  Answer plan(Cell start, Cell goal, Context& context) override;

 private:
  struct Place {
    Cell cell;
    std::size_t index;
    RingCost cost;
  };

  RingCost estimate(Cell cell) const;
  bool admit(const Meter& meter);
  Outcome search(Cell start, Cell goal, const Meter& meter);
  Outcome run(const Meter& meter);
  void expand(const Place& from, unsigned mask);
  template <int direction>
  Place moved(const Place& from, int steps) const;
  template <int direction>
  void run_straight(const Place& from);
  template <int direction>
  void march(Place at);
  void reach(const Place& at, int direction);
  Path extract(Cell start, Cell goal) const;

  const OccupancyGrid& grid_;
  MoveRule rule_;
  const CanonicalMoves& moves_;
  std::vector<std::uint8_t> neighbours_;
  JumpMap jumps_;
  SearchNodes<Ring> nodes_;
  std::vector<std::uint32_t> parents_;  // packed coordinates, of cells seen
  WideBucketQueue<Ring> open_;
  std::ptrdiff_t stride_;
  Cell goal_;
  std::size_t target_ = 0;
  std::uint32_t parent_ = 0;  // the cell being expanded
  RingCost bound_ = 0;        // cost of the best path to the goal so far
  std::uint64_t expanded_ = 0;
  std::uint64_t limit_ = 0;
};

extern template class JumpPointSearch<SmallRing>;
extern template class JumpPointSearch<LargeRing>;

}  // namespace pathrace::baselines
