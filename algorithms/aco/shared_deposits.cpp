#include "algorithms/aco/shared_deposits.hpp"

namespace pathrace::algorithms {

SharedDeposits::SharedDeposits(const Nest& nest, Trail& trail, std::size_t ants, std::size_t threads)
    : nest_(nest),
      trail_(trail),
      threads_(threads),
      bands_(nest.size(), nest.stride(), threads),
      stretches_(ants) {}

void SharedDeposits::deposit(std::span<const Walk> walks, std::span<const double> amounts, bool both_ways,
                             Executor& executor) {
  for_each_index(executor, threads_, 1, [&](std::size_t thread) {
    for (std::size_t ant = thread; ant < walks.size();
         ant += threads_) {  // as they are dealt out for walking
      if (walks[ant].arrived) bands_.split(nest_.start(), walks[ant].directions, stretches_[ant].all);
    }
  });
  for_each_index(executor, threads_, 1,
                 [&](std::size_t band) { deposit_within(bands_[band], walks, amounts, both_ways); });
}

void SharedDeposits::deposit_within(CellRange cells, std::span<const Walk> walks,
                                    std::span<const double> amounts, bool both_ways) {
  for (std::size_t ant = 0; ant < walks.size(); ++ant) {
    if (!walks[ant].arrived) continue;
    const std::span<const Stretch> stretches(stretches_[ant].all);
    for (std::size_t k = 0; k < stretches.size(); ++k) {
      if (!cells.contains(stretches[k].cell)) continue;
      deposit_on(stretches.subspan(k), walks[ant].directions, amounts[ant], both_ways);
    }
  }
}

// On the first of these stretches. A step back leads out of the cell that the step leads to: between two
// bands it is the next one's.
void SharedDeposits::deposit_on(std::span<const Stretch> stretches, std::span<const std::uint8_t> path,
                                double amount, bool both_ways) {
  const auto [first, cell] = stretches[0];
  const bool leaves = stretches.size() > 1;
  const std::size_t end = leaves ? stretches[1].first : path.size();
  if (!both_ways) return trail_.change_along(cell, path.subspan(first, end - first), 1, amount, false);
  if (first > 0) trail_.change(cell, opposite(path[first - 1]), 1, amount);
  const std::size_t within = end - first - (leaves ? 1 : 0);
  trail_.change_along(cell, path.subspan(first, within), 1, amount, true);
  if (!leaves) return;
  const int last = path[end - 1];
  trail_.change(nest_.moves().step(stretches[1].cell, opposite(last)), last, 1, amount);
}

}  // namespace pathrace::algorithms
