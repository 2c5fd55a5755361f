#include "algorithms/aco/early_deposits.hpp"

#include <atomic>

#include "core/prefetch.hpp"

namespace pathrace::algorithms {
namespace {

bool is_back(Walk& walk, std::uint32_t round) {
  return std::atomic_ref(walk.round).load(std::memory_order_acquire) == round;
}

}  // namespace

void EarlyDeposits::begin(std::size_t ants, std::uint32_t round) {
  tally_ = {};
  round_ = round;
  ants_ = trail_.begin_draft(1 - rule_.settings().evaporation) ? ants : 0;
}

// Paths that another core has written are asked for before the first is needed.
void EarlyDeposits::go_on() {
  std::size_t next = tally_.walks;
  std::size_t end = next;
  for (; end < ants_ && is_back(walks_[end], round_); ++end) prefetch(walks_[end].directions.data());
  for (; next < end; ++next) {
    const Walk& walk = walks_[next];
    tally_.add(walk, rule_);
    if (!walk.arrived) continue;
    trail_.deposit_on_draft(nest_.start(), walk.directions, rule_.amount(walk), rule_.settings().both_ways);
  }
}

void EarlyDeposits::conclude() {
  trail_.claim_copies();
  go_on();
}

bool EarlyDeposits::finish(std::size_t ants) {
  if (ants_ == 0 || ants_ != ants) return false;
  go_on();
  trail_.adopt_draft();
  ants_ = 0;
  return true;
}

}  // namespace pathrace::algorithms
