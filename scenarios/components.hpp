// Connected regions of free cells.
//
// Side by side, not corner to corner: a `strict` diagonal needs both side cells free, so two cells have a way
// between them exactly when they share a region.
#pragma once

#include <vector>

#include "core/cell.hpp"
#include "core/grid.hpp"

namespace pathrace::scenarios {

/// The cells of the region with the most cells, row by row; of equals, the region met first that way. Empty
/// when no cell is free.
std::vector<Cell> largest_region(const OccupancyGrid& grid);

}  // namespace pathrace::scenarios
