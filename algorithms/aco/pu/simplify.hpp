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

#include <cstdint>
#include <vector>

#include "core/moves.hpp"

namespace pathrace::algorithms {

/// The path without redundant corners, each step legal in `moves`; never longer, same ends. Loops that a
/// replacement closes are cut. Expects a path of legal steps in padded indices.
std::vector<std::uint32_t> without_corners(const MoveTable& moves, const std::vector<std::uint32_t>& path);

/// May a robot go straight between the centres of two free cells? It may touch a blocked cell's edge or
/// corner, but not enter it, nor pass between two blocked cells that touch at a corner. Exact, O(cells
/// passed).
bool line_of_sight(const OccupancyGrid& grid, Cell from, Cell to);

/// The cells whose centres are the corners of the straightened path: wherever three consecutive points turn
/// and the first sees the third, the middle one goes. Never longer, same ends. A step between two blocked
/// cells, legal only under the rule `free`, stays as it is.
std::vector<Cell> straightened(const OccupancyGrid& grid, const std::vector<Cell>& path);

}  // namespace pathrace::algorithms
