#include "tests/support/walks.hpp"

#include <algorithm>

namespace pathrace::testing {

algorithms::Walk walk_over(const std::vector<Cell>& cells) {
  algorithms::Walk walk;
  walk.arrived = true;
  for (std::size_t k = 1; k < cells.size(); ++k) {
    const Cell step{cells[k].x - cells[k - 1].x, cells[k].y - cells[k - 1].y};
    const auto direction = std::ranges::find(directions, step) - directions.begin();
    walk.directions.push_back(static_cast<std::uint8_t>(direction));
  }
  walk.length = algorithms::length_of(walk.directions);
  return walk;
}

std::vector<Cell> cells_over(const algorithms::Nest& nest, const algorithms::Walk& walk) {
  std::vector<Cell> cells;
  for (const std::uint32_t index : algorithms::cells_of(nest, walk)) cells.push_back(nest.cell(index));
  return cells;
}

}  // namespace pathrace::testing
