// Connected regions of free cells.
//
// Side by side, not corner to corner, but for the rule `free`: a diagonal of the other rules needs a free
// side cell, so two cells have a way between them exactly when they share a region.
#pragma once

#include <cstdint>
#include <vector>

#include "core/cell.hpp"
#include "core/grid.hpp"
#include "core/move_rule.hpp"

namespace pathrace::scenarios {

class Regions {
 public:
  explicit Regions(const OccupancyGrid& grid, MoveRule rule = MoveRule::strict);

  /// Whether there is a way from one free cell to the other. Expects cells of the map.
  bool joined(Cell a, Cell b) const { return label_[index(a)] == label_[index(b)]; }

  /// The cells of the region with the most cells, row by row; of equals, the region met first that way.
  /// Empty when no cell is free.
  std::vector<Cell> largest() const;

 private:
  std::size_t index(Cell cell) const {
    return static_cast<std::size_t>(cell.y + 1) * stride_ + static_cast<std::size_t>(cell.x + 1);
  }

  std::size_t stride_;
  std::vector<std::uint32_t> label_;  // by padded index; 0: blocked
  std::vector<std::uint32_t> sizes_;  // by label, in cells
};

/// The largest region of sides.
std::vector<Cell> largest_region(const OccupancyGrid& grid);

}  // namespace pathrace::scenarios
