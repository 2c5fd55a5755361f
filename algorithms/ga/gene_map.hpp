// The gene map: what a chromosome's genes mean.
//
// A gene is a cell of the map, as its padded index in the grid. Tables turn what the operators ask for over
// and over (where is it, in which direction lies its neighbour, is that step legal) into single look-ups.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/moves.hpp"
#include "core/planner.hpp"

namespace pathrace::algorithms {

using Gene = std::uint32_t;

class GeneMap {
 public:
  /// The problem's grid outlives the map.
  explicit GeneMap(const Problem& problem);

  Gene start() const { return start_; }
  Gene goal() const { return goal_; }
  /// Free cells other than start and goal, row by row.
  const std::vector<Gene>& inner() const { return inner_; }
  /// One past the largest gene.
  std::size_t size() const { return cells_.size(); }
  std::size_t stride() const { return stride_; }

  /// Nothing for a cell that is blocked or outside the map.
  std::optional<Gene> free_cell(Cell cell) const;
  Cell cell(Gene gene) const { return {cells_[gene].x, cells_[gene].y}; }
  /// Bit d is set when the step in direction d is legal.
  unsigned legal(Gene gene) const { return moves_[gene]; }
  Gene step(Gene gene, int direction) const { return static_cast<Gene>(moves_.step(gene, direction)); }
  /// Of the step between neighbouring cells, legal or not; -1 for any other two cells.
  int direction(Gene from, Gene to) const {
    const std::uint32_t difference = to - from + static_cast<std::uint32_t>(stride_) + 1;
    return difference < directions_.size() ? directions_[difference] : -1;
  }
  bool linked(Gene from, Gene to) const {
    const int d = direction(from, to);
    return d >= 0 && (legal(from) >> d & 1U) != 0;
  }

 private:
  struct Place {
    std::int16_t x = 0;
    std::int16_t y = 0;
  };

  const OccupancyGrid& grid_;
  MoveTable moves_;
  std::size_t stride_;
  Gene start_;
  Gene goal_;
  std::vector<Gene> inner_;
  std::vector<Place> cells_;
  std::vector<std::int8_t> directions_;  // by difference of indices, from -(stride + 1)
};

}  // namespace pathrace::algorithms
