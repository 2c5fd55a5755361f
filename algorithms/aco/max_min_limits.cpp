#include "algorithms/aco/max_min_limits.hpp"

#include <bit>

#include "core/checkpoint.hpp"

namespace pathrace::algorithms {
namespace {

int branches(const Nest& nest, const Trail& trail, std::size_t index, double lambda) {
  double least = Trail::no_limit;
  double most = 0;
  for (int d = 0; d < direction_count; ++d) {
    if ((nest.open(index) >> d & 1) == 0) continue;
    least = std::min(least, trail.pheromone(index, d));
    most = std::max(most, trail.pheromone(index, d));
  }
  int count = 0;
  for (int d = 0; d < direction_count; ++d) {
    if ((nest.open(index) >> d & 1) == 0) continue;
    count += trail.pheromone(index, d) > least + lambda * (most - least) ? 1 : 0;
  }
  return count;
}

}  // namespace

double mean_choices(const Nest& nest) {
  std::size_t cells = 0;
  std::size_t steps = 0;
  Pace pace;
  for (std::size_t index = 0; index < nest.size(); ++index) {
    pace.step();
    const unsigned mask = nest.moves()[index];
    cells += mask != 0 ? 1 : 0;
    steps += static_cast<std::size_t>(std::popcount(mask));
  }
  return cells == 0 ? 0 : 0.5 * static_cast<double>(steps) / static_cast<double>(cells);
}

double mean_branching(const Nest& nest, const Trail& trail, const Walk& walk, double lambda, bool both_ways) {
  std::int64_t sum = 0;
  std::int64_t cells = 0;
  for_each_step(nest, walk, [&](std::size_t index, int) {
    if (index == nest.start()) return;
    sum += branches(nest, trail, index, lambda);
    ++cells;
  });
  if (cells == 0) return 0;
  return static_cast<double>(sum) / static_cast<double>(both_ways ? 2 * cells : cells);
}

}  // namespace pathrace::algorithms
