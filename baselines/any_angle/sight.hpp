// Does one cell's centre see another's? The any-angle rule for segments between cell centres, in integers.
//
// The segment is followed from cell to cell; of the two edges that it may leave a cell by, twice the area
// between it and the cell's corner ahead tells which comes first. Through a corner exactly it goes on
// diagonally: it then touches the two cells at the corner's sides, and only one of them may be blocked.
//
// After J. Bresenham, "Algorithm for computer control of a digital plotter", IBM Systems Journal 4(1), 1965.
#pragma once

#include "core/cell.hpp"
#include "core/grid.hpp"

namespace pathrace::baselines {

/// Expects two free cells of the map.
bool in_sight(const OccupancyGrid& grid, Cell from, Cell to);

}  // namespace pathrace::baselines
