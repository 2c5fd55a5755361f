#include "algorithms/aco/held_path.hpp"

#include <algorithm>

namespace pathrace::algorithms {
namespace {

// Calls `visit(row)` for each row of the path.
template <typename Row, typename Visit>
void for_each_row(Row* row, const RowSteps& steps, std::span<const std::uint8_t> directions, Visit visit) {
  visit(row);
  for (const std::size_t direction : directions) {
    row += steps.on[direction];
    visit(row);
  }
}

}  // namespace

bool HeldPath::is(std::size_t from, std::span<const std::uint8_t> directions, bool both_ways) const {
  return known_ && from == from_ && both_ways == both_ways_ && std::ranges::equal(directions, directions_);
}

void HeldPath::change_to(std::size_t from, std::span<const std::uint8_t> directions, bool both_ways) {
  put_back();
  from_ = from;
  directions_.assign(directions.begin(), directions.end());
  both_ways_ = both_ways;
  known_ = true;
}

bool HeldPath::hold(TrailRow* rows, const RowSteps& steps) {
  if (held_) return true;
  if (!is_simple(rows, steps)) return false;
  where_.clear();
  float* row = rows[from_].strength.data();
  for (const std::size_t direction : directions_) {
    where_.push_back(row + direction);
    if (both_ways_) where_.push_back(row + steps.back[direction]);
    row += steps.on[direction];
  }
  strengths_.resize(where_.size());
  std::ranges::transform(where_, strengths_.begin(), [](const float* strength) { return *strength; });
  held_ = true;
  return true;
}

void HeldPath::add(float added, float least, float most) {
  for (float& tau : strengths_) tau = std::min(std::max(tau, least) + added, most);
}

void HeldPath::end() {
  put_back();
  known_ = false;
}

void HeldPath::drop() {
  held_ = known_ = false;
}

bool HeldPath::is_simple(const TrailRow* rows, const RowSteps& steps) {
  const float* const first = rows[0].strength.data();
  const float* const start = rows[from_].strength.data();
  const auto seen = [&](const float* row) -> std::uint8_t& {
    return seen_[static_cast<std::size_t>(row - first) / floats_per_row];
  };
  std::uint8_t twice = 0;
  for_each_row(start, steps, directions_, [&](const float* row) {
    twice |= seen(row);
    seen(row) = 1;
  });
  for_each_row(start, steps, directions_, [&](const float* row) { seen(row) = 0; });
  return twice == 0;
}

void HeldPath::put_back() {
  if (!held_) return;
  for (std::size_t k = 0; k < where_.size(); ++k) *where_[k] = strengths_[k];
  held_ = false;
}

}  // namespace pathrace::algorithms
