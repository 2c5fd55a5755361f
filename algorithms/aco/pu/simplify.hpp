// The path simplification operator: redundant corners go.
//
// Three nodes A, B, C of a path form a redundant corner when A and C can be joined more directly, so that the
// path gets shorter by the triangle inequality. Figure 1 of the paper shows two corners of 90 degrees and one
// of 45; its coordinates are lost, so both readings of the last are served (algorithms.md 3.4):
//
//   two straight steps, 90 degrees     -> the diagonal A-C, where the move rule allows it
//   two diagonal steps, 90 degrees     -> straight on through the cell inside the corner, if it is free
//   an angle of 45 degrees at B        -> the straight step A-C
//   a turn by 45 degrees (135 at B)    -> the segment A-C, which leaves the lattice: `straightened` only
//
// Scanned from the start; after a replacement the corner before it is looked at again, until none is left.
//
// Pu Xingcheng et al., 1.2.4.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/moves.hpp"

namespace pathrace::algorithms {

/// Cuts redundant corners off lattice paths. Holds scratch memory for one map: not for two threads at once.
class CornerCutter {
 public:
  /// `moves` outlives this.
  explicit CornerCutter(const MoveTable& moves) : moves_(moves), place_(moves.size(), 0) {}

  /// `directions` lead from the padded index `start` by legal steps and to no cell twice. Afterwards they are
  /// those of the path without redundant corners: never longer, same ends, legal. Loops that a replacement
  /// closes are cut. False when there was no corner.
  bool cut(std::size_t start, std::vector<std::uint8_t>& directions);

 private:
  struct Arrival {
    std::uint32_t cell;
    std::uint8_t direction;  // of the step that led there; the first of a path has none
  };

  bool has_corner(std::size_t start, const std::vector<std::uint8_t>& directions) const;
  void append(Arrival next);
  void push(Arrival next);
  void drop();

  const MoveTable& moves_;
  std::vector<std::uint32_t> place_;  // position on the path from 1; all 0 between calls
  std::vector<Arrival> path_;         // being rebuilt
};

/// May a robot go straight between the centres of two free cells? It may touch a blocked cell's edge or
/// corner, but not enter it, nor pass between two blocked cells that touch at a corner. Exact, O(cells
/// passed).
bool line_of_sight(const OccupancyGrid& grid, Cell from, Cell to);

/// The cells whose centres are the corners of the straightened path: wherever three consecutive points turn
/// and the first sees the third, the middle one goes. Never longer, same ends. A step between two blocked
/// cells, legal only under the rule `free`, stays as it is.
std::vector<Cell> straightened(const OccupancyGrid& grid, const std::vector<Cell>& path);

}  // namespace pathrace::algorithms
