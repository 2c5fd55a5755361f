#include "algorithms/aco/tan/components.hpp"

#include <algorithm>
#include <cstdint>

#include "core/checkpoint.hpp"
#include "core/moves.hpp"

namespace pathrace::algorithms {
namespace {

Obstacle grow(const OccupancyGrid& grid, Neighbours neighbours, Cell seed, std::vector<std::uint8_t>& seen) {
  const int stride = neighbours == Neighbours::four ? 2 : 1;  // straight directions have even numbers
  Obstacle cells{seed};
  seen[grid.index(seed)] = 1;
  Pace pace;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    pace.step();
    for (std::size_t d = 0; d < direction_count; d += static_cast<std::size_t>(stride)) {
      const Cell next{cells[i].x + directions[d].x, cells[i].y + directions[d].y};
      if (!grid.contains(next) || grid.is_free(next) || seen[grid.index(next)] != 0) continue;
      seen[grid.index(next)] = 1;
      cells.push_back(next);
    }
  }
  std::sort(cells.begin(), cells.end(), [&pace](Cell a, Cell b) {
    pace.step();
    return a.y != b.y ? a.y < b.y : a.x < b.x;
  });
  return cells;
}

}  // namespace

std::vector<Obstacle> obstacles_of(const OccupancyGrid& grid, Neighbours neighbours) {
  std::vector<std::uint8_t> seen(grid.padded_size(), 0);
  std::vector<Obstacle> obstacles;
  for (int y = 0; y < grid.height(); ++y) {
    checkpoint();
    for (int x = 0; x < grid.width(); ++x) {
      const Cell cell{x, y};
      if (grid.is_free(cell) || seen[grid.index(cell)] != 0) continue;
      obstacles.push_back(grow(grid, neighbours, cell, seen));
    }
  }
  return obstacles;
}

}  // namespace pathrace::algorithms
