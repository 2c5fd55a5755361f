// The legal steps from each cell, as planners read them: one byte per cell, one bit per direction.
//
// Directions are numbered E, SE, S, SW, W, NW, N, NE (algorithms.md 0.7); odd numbers are diagonal.
// For planners only: the referee and the reference search spell the rule out by themselves.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/cell.hpp"
#include "core/grid.hpp"
#include "core/move_rule.hpp"

namespace pathrace {

inline constexpr int direction_count = 8;
inline constexpr std::array<Cell, direction_count> directions = {
    {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};

constexpr bool is_diagonal(int direction) {
  return (direction & 1) != 0;
}
constexpr int opposite(int direction) {
  return (direction + 4) & 7;
}

class MoveTable {
 public:
  MoveTable(const OccupancyGrid& grid, MoveRule rule);

  /// Bit d is set when the step in direction d from this padded index is legal.
  std::uint8_t operator[](std::size_t index) const { return masks_[index]; }
  /// What a step in direction d adds to a padded index.
  std::ptrdiff_t offset(int direction) const { return offsets_[static_cast<std::size_t>(direction)]; }
  std::size_t step(std::size_t index, int direction) const {
    return static_cast<std::size_t>(static_cast<std::ptrdiff_t>(index) + offset(direction));
  }
  const std::uint8_t* data() const { return masks_.data(); }
  std::size_t size() const { return masks_.size(); }

 private:
  std::array<std::ptrdiff_t, direction_count> offsets_;
  std::vector<std::uint8_t> masks_;
};

}  // namespace pathrace
