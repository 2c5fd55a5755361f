#include "core/grid.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"

namespace pathrace {

OccupancyGrid::OccupancyGrid(int width, int height) : width_(width), height_(height) {
  if (width < 1 || height < 1) {
    throw InvalidScenario(fmt::format("grid must be at least 1x1 cells, got {}x{}", width, height));
  }
  if (width > max_side || height > max_side || std::int64_t{width} * height > max_cells) {
    throw InvalidScenario(fmt::format("grid must have at most {} cells a side and {} in all, got {}x{}",
                                      max_side, max_cells, width, height));
  }
  stride_ = static_cast<std::size_t>(width) + 2;
  blocked_.assign(stride_ * (static_cast<std::size_t>(height) + 2), 1);
  for (int y = 0; y < height; ++y) {
    std::fill_n(blocked_.begin() + static_cast<std::ptrdiff_t>(index({0, y})), width, std::uint8_t{0});
  }
}

std::int64_t OccupancyGrid::free_cells() const {
  return std::count(blocked_.begin(), blocked_.end(), 0);
}

void OccupancyGrid::set(Cell cell, std::uint8_t value) {
  if (!contains(cell)) {
    throw InvalidScenario(
        fmt::format("cell {},{} is outside the {}x{} grid", cell.x, cell.y, width_, height_));
  }
  blocked_[index(cell)] = value;
}

}  // namespace pathrace
