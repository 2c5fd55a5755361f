// Which steps a best-first search still has to try from a cell, given the step that led there.
//
// A step from n is pruned when the cell it leads to can be reached from n's parent without n, over cells
// beside n, at less cost; or at equal cost, when the step to n was a straight one: of equally long paths the
// one with its diagonals first is kept. Under the rule `four` horizontal steps take the part of diagonals.
// What remains depends on the eight cells around n, the direction of arrival and the move rule only: one
// table of 8 x 256 masks per rule, found by trying every way around.
//
// D. Harabor, A. Grastien, "Online Graph Pruning for Pathfinding on Grid Maps", AAAI 2011 (the pruning);
// N. Sturtevant, S. Rabin, "Canonical Orderings on Grids", IJCAI 2016 (pruning without jumps).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/grid.hpp"
#include "core/move_rule.hpp"
#include "core/moves.hpp"

namespace pathrace::baselines {

/// The free cells around each cell of a map: bit d is set when the neighbour in direction d is free. One byte
/// per padded cell, 0 for cells of the frame.
std::vector<std::uint8_t> free_neighbours(const OccupancyGrid& grid);

class CanonicalMoves {
 public:
  /// The table of this rule, made at its first use.
  static const CanonicalMoves& of(MoveRule rule);

  /// All legal steps from a cell with these free neighbours, as a mask of directions.
  std::uint8_t legal(std::uint8_t neighbours) const { return legal_[neighbours]; }
  /// The steps that remain after arriving by a step in this direction.
  std::uint8_t after(unsigned arrival, std::uint8_t neighbours) const { return after_[arrival][neighbours]; }

 private:
  explicit CanonicalMoves(MoveRule rule);

  std::array<std::uint8_t, 256> legal_{};
  std::array<std::array<std::uint8_t, 256>, direction_count> after_{};
};

}  // namespace pathrace::baselines
