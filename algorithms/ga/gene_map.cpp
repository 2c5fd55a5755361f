#include "algorithms/ga/gene_map.hpp"

#include "algorithms/affordable_map.hpp"
#include "core/checkpoint.hpp"

namespace pathrace::algorithms {

GeneMap::GeneMap(const Problem& problem)
    : grid_(affordable(problem.grid)),
      moves_(problem.grid, problem.rule),
      stride_(problem.grid.stride()),
      start_(static_cast<Gene>(problem.grid.index(problem.start))),
      goal_(static_cast<Gene>(problem.grid.index(problem.goal))),
      cells_(filled_gradually<std::vector<Place>>(problem.grid.padded_size(), Place{})),
      directions_(2 * problem.grid.stride() + 3, -1) {
  const auto centre = static_cast<std::ptrdiff_t>(stride_) + 1;
  for (int d = 0; d < direction_count; ++d) {
    directions_[static_cast<std::size_t>(centre + moves_.offset(d))] = static_cast<std::int8_t>(d);
  }
  inner_.reserve(static_cast<std::size_t>(problem.grid.free_cells()));
  Pace pace;
  for (std::size_t index = 0; index < cells_.size(); ++index) {
    pace.step();
    const Cell cell = problem.grid.cell(index);
    cells_[index] = {static_cast<std::int16_t>(cell.x), static_cast<std::int16_t>(cell.y)};
    if (problem.grid.blocked_at(index) || index == start_ || index == goal_) continue;
    inner_.push_back(static_cast<Gene>(index));
  }
}

std::optional<Gene> GeneMap::free_cell(Cell cell) const {
  if (!grid_.is_free(cell)) return std::nullopt;
  return static_cast<Gene>(grid_.index(cell));
}

}  // namespace pathrace::algorithms
