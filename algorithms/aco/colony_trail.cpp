// What a colony does to its trail.
#include "algorithms/aco/colony.hpp"

namespace pathrace::algorithms {
namespace {

constexpr std::size_t steps_worth_sharing = 8192;  // some thirty microseconds of deposits

}  // namespace

void Colony::deposit(const Walk& walk, double amount) {
  change(walk, 1, amount);
}

void Colony::imprint(std::size_t count) {
  if (deposits_ && deposits_->finish(count)) return;
  const Imprint imprint = rule_.imprint();
  if (imprint.persistence != 1) trail_->evaporate(imprint.persistence);
  if (imprint.is_deposit()) return deposit_all(count);
  for (std::size_t k = 0; k < count; ++k) {
    const Walk& walk = walks_[k];
    if (!walk.arrived && !imprint.of_the_dead) continue;
    const double amount = rule_.amount(walk);
    change(walk, imprint.factor, amount);
    if (!imprint.on_popped) continue;
    for (const Step step : walk.popped) {
      trail_->change(step.index, step.direction, imprint.factor, amount, settings_.both_ways);
    }
  }
}

// Few steps are not worth a loop on several threads.
void Colony::deposit_all(std::size_t count) {
  std::size_t steps = 0;
  for (std::size_t k = 0; k < count; ++k) {
    amounts_[k] = walks_[k].arrived ? rule_.amount(walks_[k]) : 0;
    steps += walks_[k].arrived ? walks_[k].directions.size() : 0;
  }
  if (!shared_ || steps < steps_worth_sharing) return deposit_in_turn(count);
  shared_->deposit({walks_.data(), count}, {amounts_.data(), count}, settings_.both_ways, round_, *executor_);
}

void Colony::deposit_in_turn(std::size_t count) {
  Trail::Deposits deposits(*trail_);
  for (std::size_t k = 0; k < count; ++k) {
    if (!walks_[k].arrived) continue;
    deposits.add(nest_.start(), walks_[k].directions, amounts_[k], settings_.both_ways);
  }
}

void Colony::change(const Walk& walk, double factor, double amount) {
  trail_->change_along(nest_.start(), walk.directions, factor, amount, settings_.both_ways);
}

void Colony::close(std::size_t index) {
  if (nest_.closed(index)) return;
  nest_.close(index);
  if (!nest_.closed(index)) return;
  for (int d = 0; d < direction_count; ++d) {
    if ((nest_.moves()[index] >> d & 1) != 0) trail_->close(nest_.moves().step(index, d), opposite(d));
  }
}

void Colony::close_step(std::size_t index, int direction) {
  nest_.close_step(index, direction);
  trail_->close(index, direction);
  trail_->close(nest_.moves().step(index, direction), opposite(direction));
}

}  // namespace pathrace::algorithms
