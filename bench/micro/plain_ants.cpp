#include "bench/micro/plain_ants.hpp"

#include <cmath>

#include "core/moves.hpp"

namespace pathrace::bench::micro {

PlainColony::PlainColony(const Problem& problem, double beta, bool backtrack)
    : neighbours_(problem.grid.padded_size()),
      start_(problem.grid.index(problem.start)),
      goal_(problem.grid.index(problem.goal)),
      backtrack_(backtrack) {
  const MoveTable moves(problem.grid, problem.rule);
  for (std::size_t cell = 0; cell < neighbours_.size(); ++cell) {
    for (int d = 0; d < direction_count; ++d) {
      if ((moves[cell] >> d & 1) == 0) continue;
      const std::size_t next = moves.step(cell, d);
      const Cell at = problem.grid.cell(next);
      const double distance = std::hypot(at.x - problem.goal.x, at.y - problem.goal.y);
      const double eta = next == goal_ ? 100 : 1 / distance;
      neighbours_[cell].push_back({next, 0, is_diagonal(d) ? std::sqrt(2.0) : 1.0, std::pow(eta, beta), 8});
    }
  }
  for (std::size_t cell = 0; cell < neighbours_.size(); ++cell) {
    for (Neighbour& neighbour : neighbours_[cell]) {
      const std::vector<Neighbour>& back = neighbours_[neighbour.cell];
      while (back[neighbour.reverse].cell != cell) ++neighbour.reverse;
    }
  }
}

int PlainColony::choose(std::size_t cell, const std::vector<bool>& visited, Stream& stream) const {
  const std::vector<Neighbour>& options = neighbours_[cell];
  double total = 0;
  for (const Neighbour& option : options) {
    if (!visited[option.cell]) total += option.pheromone * option.desirability;
  }
  if (total == 0) return -1;
  double point = stream.uniform() * total;
  int last = -1;
  for (std::size_t i = 0; i < options.size(); ++i) {
    if (visited[options[i].cell]) continue;
    last = static_cast<int>(i);
    point -= options[i].pheromone * options[i].desirability;
    if (point < 0) break;
  }
  return last;
}

PlainWalk PlainColony::walk(Stream stream) const {
  PlainWalk walk;
  std::vector<bool> visited(neighbours_.size(), false);
  walk.path.push_back(start_);
  visited[start_] = true;
  while (walk.path.back() != goal_) {
    ++walk.decisions;
    const int choice = choose(walk.path.back(), visited, stream);
    if (choice >= 0) {
      walk.path.push_back(neighbours_[walk.path.back()][static_cast<std::size_t>(choice)].cell);
      visited[walk.path.back()] = true;
    } else if (backtrack_ && walk.path.size() > 1) {
      walk.path.pop_back();
    } else {
      return walk;
    }
  }
  walk.arrived = true;
  return walk;
}

void PlainColony::learn(const std::vector<PlainWalk>& walks, double persistence) {
  for (std::vector<Neighbour>& options : neighbours_) {
    for (Neighbour& option : options) option.pheromone *= persistence;
  }
  for (const PlainWalk& walk : walks) {
    if (!walk.arrived) continue;
    double length = 0;
    std::vector<Neighbour*> steps;
    for (std::size_t i = 0; i + 1 < walk.path.size(); ++i) {
      for (Neighbour& option : neighbours_[walk.path[i]]) {
        if (option.cell != walk.path[i + 1]) continue;
        steps.push_back(&option);
        length += option.length;
      }
    }
    for (Neighbour* step : steps) {
      step->pheromone += 1 / length;
      neighbours_[step->cell][step->reverse].pheromone += 1 / length;
    }
  }
}

}  // namespace pathrace::bench::micro
