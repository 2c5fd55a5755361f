#include "algorithms/aco/dead_ends.hpp"

namespace pathrace::algorithms {

DeadEnds::DeadEnds(const Problem& problem, DeadTable table, DeadCells::Layer layer) {
  if (table == DeadTable::none || table == DeadTable::per_ant) return;
  moves_.emplace(problem.grid, problem.rule);
  cells_.emplace(*moves_, table, layer, problem.grid.index(problem.start), problem.grid.index(problem.goal));
}

void DeadEnds::mark(Colony& colony, std::size_t count) {
  if (!global()) return;
  for (std::size_t k = 0; k < count; ++k) {
    for (const Step& step : colony.walks()[k].popped) {
      const std::size_t cell = colony.nest().moves().step(step.index, step.direction);
      for (const std::size_t lost : cells_->stepped_back_from(cell)) close_around(colony, lost);
    }
  }
}

// A lost cell costs steps of its own and, as an obstacle, steps between its neighbours.
void DeadEnds::close_around(Colony& colony, std::size_t cell) const {
  for (int at = 0; at < direction_count; ++at) {
    const std::size_t neighbour = moves_->step(cell, at);
    for (int d = 0; d < direction_count; ++d) {
      const bool open = (colony.nest().open(neighbour) >> d & 1) != 0;
      if (open && ((*moves_)[neighbour] >> d & 1) == 0) colony.close_step(neighbour, d);
    }
  }
}

}  // namespace pathrace::algorithms
