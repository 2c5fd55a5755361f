#include "algorithms/aco/scout.hpp"

#include <vector>

#include "core/checkpoint.hpp"

namespace pathrace::algorithms {
namespace {

// The open, unseen step with the largest desirability, the first of equals; -1 when there is none.
int greedy_step(const Nest& nest, const Trail& trail, const std::vector<std::uint8_t>& seen,
                std::size_t cell) {
  const auto& desirability = trail.rows()[cell].desirability;
  int best = -1;
  for (int d = 0; d < direction_count; ++d) {
    if ((nest.open(cell) >> d & 1) == 0 || seen[nest.moves().step(cell, d)] != 0) continue;
    if (best < 0 ||
        desirability[static_cast<std::size_t>(d)] > desirability[static_cast<std::size_t>(best)]) {
      best = d;
    }
  }
  return best;
}

}  // namespace

ScoutReport send_scout(const Nest& nest, const Trail& trail, std::uint64_t limit) {
  ScoutReport report;
  std::vector<std::uint8_t> seen(nest.size(), 0);
  std::vector<std::uint8_t> directions;
  std::size_t cell = nest.start();
  seen[cell] = 1;
  Pace pace;
  while (cell != nest.goal()) {
    if (report.decisions == limit) return report;
    ++report.decisions;
    pace.step();
    const int d = greedy_step(nest, trail, seen, cell);
    if (d >= 0) {
      cell = nest.moves().step(cell, d);
      seen[cell] = 1;
      directions.push_back(static_cast<std::uint8_t>(d));
    } else if (!directions.empty()) {
      cell = nest.moves().step(cell, opposite(directions.back()));
      directions.pop_back();
    } else {
      report.unreachable = true;
      return report;
    }
  }
  report.scout = {length_of(directions).value(), static_cast<double>(directions.size())};
  return report;
}

}  // namespace pathrace::algorithms
