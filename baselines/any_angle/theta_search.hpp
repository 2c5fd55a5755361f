// Theta* and Lazy Theta*: A* on cell centres whose parents need not be neighbours.
//
// A cell takes its parent's parent for a parent when that one sees it. Theta* looks when a cell is reached;
// Lazy Theta* takes it for granted and looks when the cell is expanded, where the best expanded neighbour
// replaces a parent out of sight. Neither promises the shortest path: all turns are at cell centres.
//
// A. Nash, K. Daniel, S. Koenig, A. Felner, "Theta*: Any-Angle Path Planning on Grids", AAAI 2007;
// A. Nash, S. Koenig, C. Tovey, "Lazy Theta*: Any-Angle Path Planning and Path Length Analysis in 3D", AAAI
// 2010. Steps are those of the move rule; under `free`, which passes between blocked cells that touch at a
// corner, those of `squeeze`: the any-angle rule forbids the rest.
#pragma once

#include <cstdint>
#include <vector>

#include "core/moves.hpp"
#include "core/planner.hpp"

namespace pathrace::baselines {

enum class Looking { at_reaching, at_expanding };

class ThetaSearch final : public MapPlanner {
 public:
  ThetaSearch(const Terrain& terrain, Looking looking);

  /// One evaluation (the path found), one iteration; a check is a cell expanded; the counter `sight_lines`
  /// tells how often one cell looked for another.
  Answer plan(Cell start, Cell goal, Context& context) override;

 private:
  struct Node {
    double cost;
    Cell parent;
    std::uint32_t query;  // twice the number of the query that saw it last, and one more when expanded
  };
  struct Open {
    double f;
    double cost;
    Cell cell;
  };

  static bool later(const Open& a, const Open& b);
  Node& node(Cell cell) { return nodes_[grid_.index(cell)]; }
  const Node& node(Cell cell) const { return nodes_[grid_.index(cell)]; }
  bool seen(const Node& node) const { return node.query / 2 == query_; }
  bool expanded(const Node& node) const { return node.query == 2 * query_ + 1; }
  bool sees(Cell from, Cell to);

  void restart();
  bool search(Cell start, Meter& meter);
  void expand(Cell cell);
  void find_parent(Cell cell);
  void reach(Cell cell, Cell parent);
  Path extract(Cell start) const;

  const OccupancyGrid& grid_;
  Looking looking_;
  MoveTable moves_;
  std::vector<Node> nodes_;
  std::vector<Open> open_;  // a heap
  std::uint32_t query_ = 0;
  Cell goal_;
  std::uint64_t sight_lines_ = 0;
  bool cut_ = false;
};

}  // namespace pathrace::baselines
