#include "algorithms/aco/early_deposits.hpp"

#include <algorithm>

#include "core/prefetch.hpp"

namespace pathrace::algorithms {

EarlyDeposits::EarlyDeposits(const PheromoneRule& rule, const Nest& nest, Trail& trail,
                             const std::vector<Walk>& walks, const RollCall& roll_call)
    : rule_(rule),
      nest_(nest),
      trail_(trail),
      walks_(walks),
      roll_call_(roll_call),
      imprint_(rule.imprint()),
      plain_(imprint_.factor == 1 && !imprint_.on_popped),
      until_a_step_back_(rule.deposits_early() == Early::until_a_step_back) {
  trail_.keep_draft();
}

void EarlyDeposits::begin(std::size_t ants, std::uint32_t round) {
  tally_ = {};
  round_ = round;
  ants_ = 0;
  trail_.drop_draft();
  if (rounds_off_ > 0) {
    --rounds_off_;
  } else if (trail_.begin_draft(imprint_.persistence)) {
    ants_ = ants;
  }
}

// Paths that another core has written are asked for before the first is needed.
void EarlyDeposits::go_on() {
  std::size_t next = tally_.walks;
  std::size_t end = next;
  for (; end < ants_ && roll_call_.has(end, round_); ++end) prefetch(walks_[end].directions.data());
  for (; next < end; ++next) {
    const Walk& walk = walks_[next];
    if (until_a_step_back_ && walk.pops > 0) return give_up();
    tally_.add(walk, rule_);
    if (walk.arrived || imprint_.of_the_dead) leave_imprint(walk);
  }
}

void EarlyDeposits::leave_imprint(const Walk& walk) {
  const double amount = rule_.amount(walk);
  const bool both_ways = rule_.settings().both_ways;
  if (plain_) return trail_.deposit_on_draft(nest_.start(), walk.directions, amount, both_ways);
  trail_.change_draft_along(nest_.start(), walk.directions, imprint_.factor, amount, both_ways);
  if (!imprint_.on_popped) return;
  for (const Step& step : walk.popped) {
    trail_.change_draft_along(step.index, {&step.direction, 1}, imprint_.factor, amount, both_ways);
  }
}

// An iteration with steps back is likely followed by more of them.
void EarlyDeposits::give_up() {
  ants_ = 0;
  pause_ = std::min(2 * pause_ + 1, longest_pause);
  rounds_off_ = pause_;
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
  pause_ = 0;
  return true;
}

}  // namespace pathrace::algorithms
