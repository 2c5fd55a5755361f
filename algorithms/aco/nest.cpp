#include "algorithms/aco/nest.hpp"

#include "algorithms/affordable_map.hpp"

namespace pathrace::algorithms {

Nest::Nest(const Problem& problem)
    : moves_(affordable(problem.grid), problem.rule),
      stride_(problem.grid.stride()),
      free_cells_(static_cast<std::size_t>(problem.grid.free_cells())),
      start_(problem.grid.index(problem.start)),
      goal_(problem.grid.index(problem.goal)),
      open_(moves_.data(), moves_.data() + moves_.size()),
      closed_(moves_.size(), 0) {}

void Nest::close(std::size_t index) {
  if (index == start_ || index == goal_) return;
  closed_[index] = 1;
  for (int d = 0; d < direction_count; ++d) {
    if ((moves_[index] >> d & 1) == 0) continue;  // legal steps are legal both ways
    open_[moves_.step(index, d)] &= static_cast<std::uint8_t>(~(1U << opposite(d)));
  }
}

void Nest::close_step(std::size_t index, int direction) {
  const std::size_t target = moves_.step(index, direction);
  open_[index] &= static_cast<std::uint8_t>(~(1U << direction));
  open_[target] &= static_cast<std::uint8_t>(~(1U << opposite(direction)));
}

}  // namespace pathrace::algorithms
