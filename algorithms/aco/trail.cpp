#include "algorithms/aco/trail.hpp"

#include <algorithm>
#include <cmath>

#include "algorithms/aco/power.hpp"
#include "core/checkpoint.hpp"

namespace pathrace::algorithms {
namespace {

// Strengths stay between these, so that eight of them have a finite sum and none is lost.
constexpr float weakest = 0x1p-100F;
constexpr float strongest = 0x1p100F;
constexpr float largest_stored = 0x1p120F;

std::array<float, direction_count> desirabilities(unsigned mask, std::size_t index, double beta,
                                                  const Trail::Heuristic& eta) {
  std::array<double, direction_count> value{};
  double largest = 0;
  for (int d = 0; d < direction_count; ++d) {
    if ((mask >> d & 1U) == 0) continue;
    value[static_cast<std::size_t>(d)] = eta(index, d);
    largest = std::max(largest, value[static_cast<std::size_t>(d)]);
  }
  std::array<float, direction_count> row{};
  for (std::size_t d = 0; d < direction_count; ++d) {
    if ((mask >> d & 1U) != 0) row[d] = static_cast<float>(power(value[d] / largest, beta));
  }
  return row;
}

}  // namespace

Trail::Trail(const MoveTable& moves, double initial, double alpha, double beta, const Heuristic& eta)
    : moves_(moves),
      steps_(moves),
      alpha_(alpha),
      smallest_scale_(std::ldexp(1.0, -static_cast<int>(40 / std::max(1.0, alpha)))),
      rows_(filled_gradually<Rows>(moves.size(), TrailRow{})),
      held_(moves.size()) {
  if (alpha != 1) assign_gradually(stored_, moves.size(), Stored{});
  Pace pace;
  for (std::size_t index = 0; index < moves.size(); ++index) {
    pace.step();
    if (moves[index] == 0) continue;
    rows_[index].desirability = desirabilities(moves[index], index, beta, eta);
    for (int d = 0; d < direction_count; ++d) {
      if ((moves[index] >> d & 1) == 0) continue;
      least_desirability_ =
          std::min(least_desirability_, rows_[index].desirability[static_cast<std::size_t>(d)]);
    }
  }
  reset(initial);
}

float& Trail::stored(std::size_t index, int direction) {
  const auto d = static_cast<std::size_t>(direction);
  return stored_.empty() ? rows_[index].strength[d] : stored_[index][d];
}

const float& Trail::stored(std::size_t index, int direction) const {
  const auto d = static_cast<std::size_t>(direction);
  return stored_.empty() ? rows_[index].strength[d] : stored_[index][d];
}

float Trail::strength_of(float stored) const {
  const auto strength = static_cast<float>(power(stored / unit_, alpha_));
  return std::min(std::max(strength, weakest), strongest);
}

float Trail::weight(std::size_t index, int direction) const {
  const auto d = static_cast<std::size_t>(direction);
  return std::max(rows_[index].strength[d], least_strength_) * rows_[index].desirability[d];
}

double Trail::pheromone(std::size_t index, int direction) const {
  return scale_ * double{std::max(stored(index, direction), least_)};
}

void Trail::set(std::size_t index, int direction, double value) {
  change(index, direction, 0, value);
}

void Trail::change(std::size_t index, int direction, double factor, double amount) {
  if (!draft_.empty()) changed_.add(index);
  float& tau = stored(index, direction);
  alteration(static_cast<float>(factor), static_cast<float>(amount / scale_), least_, most_)(tau);
  if (!stored_.empty()) rows_[index].strength[static_cast<std::size_t>(direction)] = strength_of(tau);
}

void Trail::change_along(std::size_t index, std::span<const std::uint8_t> directions, double factor,
                         double amount, bool both_ways) {
  if (!draft_.empty()) mark_changes(index, directions, both_ways);
  if (stored_.empty()) return change_strengths(index, directions, factor, amount, both_ways);
  for (const std::uint8_t direction : directions) {
    change(index, direction, factor, amount, both_ways);
    index = moves_.step(index, direction);
  }
}

void Trail::mark_changes(std::size_t index, std::span<const std::uint8_t> directions, bool both_ways) {
  for (const std::uint8_t direction : directions) {
    changed_.add(index);
    index = moves_.step(index, direction);
  }
  if (both_ways) changed_.add(index);
}

// The hot form of `change`, for alpha = 1, where strength and stored tau are the same.
void Trail::change_strengths(std::size_t index, std::span<const std::uint8_t> directions, double factor,
                             double amount, bool both_ways) {
  const auto kept = static_cast<float>(factor);
  const auto added = static_cast<float>(amount / scale_);
  float* const row = rows_[index].strength.data();
  const auto along = [&](const auto& change) {
    const auto ignore = [](const float*) {};
    both_ways ? for_each_strength<true>(row, steps_, directions, change, ignore)
              : for_each_strength<false>(row, steps_, directions, change, ignore);
  };
  if (kept == 1 && added >= 0) return along(addition(added, least_, most_));
  along(alteration(kept, added, least_, most_));
}

void Trail::Deposits::add(std::size_t index, std::span<const std::uint8_t> directions, double amount,
                          bool both_ways) {
  Trail& trail = trail_;
  const bool held = trail.stored_.empty() &&
                    trail.held_.comes(trail.rows_.data(), trail.steps_, index, directions, both_ways);
  if (!held) return trail.change_along(index, directions, 1, amount, both_ways);
  trail.held_.add(static_cast<float>(amount / trail.scale_), trail.least_, trail.most_);
}

void Trail::reset(double value) {
  draft_is_close_ = false;
  scale_ = 1;
  rescale();
  const float tau = std::min(std::max(static_cast<float>(value), least_), most_);
  Pace pace;
  for (std::size_t index = 0; index < rows_.size(); ++index) {
    pace.step();
    for (int d = 0; d < direction_count; ++d) stored(index, d) = tau;
  }
  rewrite_strengths();
}

void Trail::evaporate(double persistence) {
  if (scale_ * persistence < smallest_scale_) return rewrite(persistence);
  scale_ *= persistence;
  rescale();
}

void Trail::limit(double lower, double upper) {
  const bool less_room_above = upper < upper_;
  if (less_room_above || lower < lower_) rewrite();  // what has stood at the old limits stays there
  lower_ = lower;
  upper_ = upper;
  rescale();
  if (less_room_above) rewrite();
}

Trail::Bounds Trail::bounds_at(double scale) const {
  return {static_cast<float>(lower_ / scale), std::min(static_cast<float>(upper_ / scale), largest_stored)};
}

void Trail::rescale() {
  const auto [least, most] = bounds_at(scale_);
  least_ = least;
  most_ = most;
  least_strength_ = stored_.empty() ? least_ : strength_of(least_);
}

void Trail::rewrite(double persistence) {
  draft_is_close_ = false;
  const auto factor = static_cast<float>(scale_ * persistence);
  scale_ = 1;
  rescale();
  Pace pace;
  for (std::size_t index = 0; index < rows_.size(); ++index) {
    pace.step();
    for (int d = 0; d < direction_count; ++d) {
      float& tau = stored(index, d);
      tau = std::min(std::max(tau * factor, least_), most_);
    }
  }
  rewrite_strengths();
}

void Trail::rewrite_strengths() {
  if (stored_.empty()) return;
  float largest = 0;
  Pace pace;
  for (const Stored& row : stored_) {
    pace.step();
    largest = std::max(largest, *std::max_element(row.begin(), row.end()));
  }
  unit_ = largest > 0 ? largest : 1;
  rescale();
  for (std::size_t index = 0; index < rows_.size(); ++index) {
    pace.step();
    for (std::size_t d = 0; d < direction_count; ++d) {
      rows_[index].strength[d] = strength_of(stored_[index][d]);
    }
  }
}

}  // namespace pathrace::algorithms
