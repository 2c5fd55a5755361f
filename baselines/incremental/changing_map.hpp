// A map that changes between searches: the legal steps of each cell, and which cells have won or lost some.
//
// One byte of free neighbours and one of legal steps per padded cell; a cell that blocks or frees flips one
// bit in each of its eight neighbours.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "baselines/grid/canonical_moves.hpp"
#include "core/scenario.hpp"

namespace pathrace::baselines {

class ChangingMap {
 public:
  /// Keeps nothing of the terrain but its look at this moment.
  explicit ChangingMap(const Terrain& terrain);

  /// The map now looks like this grid, which has the first one's sides. Returns the padded indices of the
  /// cells whose legal steps have changed, each once; valid until the next call.
  const std::vector<std::uint32_t>& look(const OccupancyGrid& grid);

  /// Bit d is set when the step in direction d is legal. Legal steps are legal both ways.
  std::uint8_t steps(std::size_t index) const { return steps_[index]; }
  std::size_t size() const { return steps_.size(); }

 private:
  bool is_as_it_was(const OccupancyGrid& grid, std::size_t first, std::size_t end) const;
  void flip(std::size_t index);
  void suspect(std::size_t index);

  const CanonicalMoves& moves_;
  std::array<std::ptrdiff_t, direction_count> offsets_{};
  std::vector<std::uint8_t> blocked_;
  std::vector<std::uint8_t> neighbours_;
  std::vector<std::uint8_t> steps_;
  std::vector<std::uint8_t> suspected_;
  std::vector<std::uint32_t> changed_;
};

}  // namespace pathrace::baselines
