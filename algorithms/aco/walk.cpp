#include "algorithms/aco/walk.hpp"

namespace pathrace::algorithms {

int turns_of(const std::vector<std::uint8_t>& directions) {
  int count = 0;
  for (std::size_t i = 1; i < directions.size(); ++i) count += directions[i] != directions[i - 1] ? 1 : 0;
  return count;
}

LatticeLength length_of(const std::vector<std::uint8_t>& directions) {
  std::uint64_t diagonal = 0;
  for (const std::uint8_t direction : directions) diagonal += direction & 1U;
  return {static_cast<std::int64_t>(directions.size() - diagonal), static_cast<std::int64_t>(diagonal)};
}

std::vector<std::uint32_t> cells_of(const Nest& nest, const Walk& walk) {
  std::vector<std::uint32_t> cells;
  cells.reserve(walk.directions.size() + 1);
  cells.push_back(static_cast<std::uint32_t>(nest.start()));
  for_each_step(nest, walk, [&](std::size_t index, int direction) {
    cells.push_back(static_cast<std::uint32_t>(nest.moves().step(index, direction)));
  });
  return cells;
}

Path path_of(const Nest& nest, const Walk& walk) {
  Path path;
  path.points.reserve(walk.directions.size() + 1);
  for (const std::uint32_t index : cells_of(nest, walk)) path.points.push_back(centre(nest.cell(index)));
  return path;
}

}  // namespace pathrace::algorithms
