// The legal steps of a map that loses cells while ants walk it.
//
// One byte per padded cell as in MoveTable, at first a copy of it. A cell is lost in one of two layers:
//   dead      nobody enters it any more; it does not block the diagonals beside it
//   obstacle  it has become a wall: under `strict` and `squeeze` it also closes diagonals past it
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/moves.hpp"

namespace pathrace::algorithms {

class LiveMoves {
 public:
  LiveMoves(const OccupancyGrid& grid, MoveRule rule);

  /// Bit d is set when the step in direction d is legal and leads to a living cell.
  std::uint8_t operator[](std::size_t index) const { return masks_[index]; }
  const std::uint8_t* data() const { return masks_.data(); }
  std::size_t size() const { return masks_.size(); }
  std::size_t step(std::size_t index, int direction) const {
    return static_cast<std::size_t>(static_cast<std::ptrdiff_t>(index) +
                                    offsets_[static_cast<std::size_t>(direction)]);
  }

  /// A free cell of the map that has been lost in neither layer.
  bool alive(std::size_t index) const { return closed_[index] == 0; }

  /// Loses a living cell in the dead layer: the steps into it and out of it go.
  void lose(std::size_t index);
  /// Loses a living cell in the obstacle layer.
  void wall(std::size_t index);
  /// Undoes wall() of the same cell, when nothing was lost since.
  void unwall(std::size_t index);

 private:
  struct Patch {
    std::array<std::size_t, direction_count + 1> cells;
    std::array<std::uint8_t, direction_count + 1> masks;
  };
  Patch patch_around(std::size_t index) const;
  void forbid(std::size_t from, int direction);

  MoveRule rule_;
  std::array<std::ptrdiff_t, direction_count> offsets_{};
  std::vector<std::uint8_t> masks_;
  std::vector<std::uint8_t> closed_;    // blocked or lost
  std::vector<std::uint8_t> obstacle_;  // blocked or walled: what the corner rule sees
  Patch before_wall_{};
};

}  // namespace pathrace::algorithms
