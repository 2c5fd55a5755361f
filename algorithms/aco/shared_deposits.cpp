#include "algorithms/aco/shared_deposits.hpp"

namespace pathrace::algorithms {

SharedDeposits::SharedDeposits(const Nest& nest, Trail& trail, std::size_t ants, std::size_t threads)
    : nest_(nest),
      trail_(trail),
      threads_(threads),
      bands_(nest.size(), nest.stride(), threads),
      stretches_(ants) {}

// Ants are dealt out in turn for walking, and so are their paths. Whoever is the first to write the round
// into a slot fills it; nobody reads it before all threads are back.
void SharedDeposits::prepare(std::span<const Walk> walks, const RollCall& roll_call, std::uint32_t round,
                             std::size_t thread) {
  for (std::size_t turn = 0; turn < threads_; ++turn) {
    for (std::size_t ant = (thread + turn) % threads_; ant < walks.size(); ant += threads_) {
      if (stretches_[ant].round.load(std::memory_order_relaxed) == round) continue;
      if (!roll_call.has(ant, round)) continue;
      if (stretches_[ant].round.exchange(round, std::memory_order_relaxed) != round) split(ant, walks[ant]);
    }
  }
}

void SharedDeposits::deposit(std::span<const Walk> walks, std::span<const double> amounts, bool both_ways,
                             std::uint32_t round, Executor& executor) {
  split_the_rest(walks, round, executor);
  for_each_index(executor, threads_, 1,
                 [&](std::size_t band) { deposit_within(bands_[band], walks, amounts, both_ways); });
}

void SharedDeposits::split_the_rest(std::span<const Walk> walks, std::uint32_t round, Executor& executor) {
  const auto is_due = [&](std::size_t ant) {
    return stretches_[ant].round.load(std::memory_order_relaxed) != round;
  };
  bool any_is_due = false;
  for (std::size_t ant = 0; ant < walks.size(); ++ant) any_is_due |= is_due(ant);
  if (!any_is_due) return;
  for_each_index(executor, threads_, 1, [&](std::size_t thread) {
    for (std::size_t ant = thread; ant < walks.size(); ant += threads_) {
      if (is_due(ant)) split(ant, walks[ant]);
    }
  });
}

void SharedDeposits::split(std::size_t ant, const Walk& walk) {
  if (walk.arrived) bands_.split(nest_.start(), walk.directions, stretches_[ant].all);
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
