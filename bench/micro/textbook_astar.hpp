// A* as textbooks have it: the yardstick that the tuned searches are measured against.
//
// std::priority_queue of doubles with lazy deletion, octile heuristic, arrays that are made anew for each
// query, bounds and corners asked of the grid at every step. Move rule `strict`.
#pragma once

#include <cstdint>
#include <vector>

#include "core/cell.hpp"
#include "core/grid.hpp"

namespace pathrace::bench::micro {

struct TextbookAnswer {
  std::vector<Cell> cells;  ///< from start to goal; empty when there is no way
  double length = 0;
  std::uint64_t expanded = 0;
};

TextbookAnswer textbook_astar(const OccupancyGrid& grid, Cell start, Cell goal);

}  // namespace pathrace::bench::micro
