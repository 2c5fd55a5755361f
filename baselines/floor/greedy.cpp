// The greedy floor: step to the unvisited neighbour nearest to the goal, until there or stuck.
//
// No planner that learns or searches should do worse. Distances are squared Euclidean, so ties are exact; the
// first direction wins them. One walk is one evaluation, one step is one check.
#include <bit>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/catalogue.hpp"
#include "core/checkpoint.hpp"
#include "core/lattice_length.hpp"
#include "core/moves.hpp"

namespace pathrace::baselines {
namespace {

std::int64_t squared_distance(Cell a, Cell b) {
  const std::int64_t dx = a.x - b.x;
  const std::int64_t dy = a.y - b.y;
  return dx * dx + dy * dy;
}

int nearest_to_goal(const Problem& problem, const MoveTable& moves, const std::vector<std::uint8_t>& visited,
                    Cell cell) {
  const std::size_t index = problem.grid.index(cell);
  int best = -1;
  std::int64_t least = std::numeric_limits<std::int64_t>::max();
  for (unsigned mask = moves[index]; mask != 0; mask &= mask - 1) {
    const int direction = std::countr_zero(mask);
    if (visited[moves.step(index, direction)] != 0) continue;
    const Cell step = directions[static_cast<std::size_t>(direction)];
    const std::int64_t distance = squared_distance({cell.x + step.x, cell.y + step.y}, problem.goal);
    if (distance < least) {
      least = distance;
      best = direction;
    }
  }
  return best;
}

Answer walk(const Problem& problem, Context& context) {
  if (context.meter.exhausted()) return std::nullopt;
  const MoveTable moves(problem.grid, problem.rule);
  std::vector<std::uint8_t> visited(problem.grid.padded_size(), 0);
  std::vector<Cell> cells{problem.start};
  LatticeLength length;
  Pace pace;
  while (cells.back() != problem.goal) {
    if (context.meter.checks_left() == 0) return std::nullopt;
    const Cell cell = cells.back();
    visited[problem.grid.index(cell)] = 1;
    const int direction = nearest_to_goal(problem, moves, visited, cell);
    context.meter.spend_checks(1);
    pace.step();
    if (direction < 0) break;
    const Cell step = directions[static_cast<std::size_t>(direction)];
    cells.push_back({cell.x + step.x, cell.y + step.y});
    (is_diagonal(direction) ? length.diagonal : length.straight) += 1;
  }
  context.meter.spend_evaluations(1);
  context.meter.end_iteration();
  if (cells.back() != problem.goal) return std::nullopt;
  context.meter.improved(length.value());
  return lattice_path(cells);
}

}  // namespace

PlannerCard greedy_card() {
  PlannerCard card;
  card.name = "greedy";
  card.kind = Kind::floor;
  card.random = false;
  card.summary = "walks to the unvisited neighbour nearest to the goal, until stuck";
  card.source = "floor baseline of this project";
  return without_parameters(std::move(card), unprepared(walk));
}

}  // namespace pathrace::baselines
