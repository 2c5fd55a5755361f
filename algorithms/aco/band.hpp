// A part of the trail that one thread changes, while others change the rest.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "algorithms/aco/trail_row.hpp"

namespace pathrace::algorithms {

/// Neighbouring rows.
class Band {
 public:
  /// The rows begin..end-1 of those from `rows` on.
  Band(const TrailRow* rows, std::size_t begin, std::size_t end)
      : first_(rows->strength.data() + begin * floats_per_row), size_((end - begin) * floats_per_row) {}

  bool holds(const float* strength) const { return static_cast<std::size_t>(strength - first_) < size_; }
  /// True when it also holds all that is at most `reach` floats off. reach >= 0.
  bool holds_around(const float* strength, std::ptrdiff_t reach) const {
    const auto around = static_cast<std::size_t>(reach);
    return size_ > 2 * around && static_cast<std::size_t>(strength - first_ - reach) < size_ - 2 * around;
  }
  /// True when it holds nothing that is at most `reach` floats off.
  bool is_far_from(const float* strength, std::ptrdiff_t reach) const {
    return static_cast<std::size_t>(strength - first_ + reach) >= size_ + 2 * static_cast<std::size_t>(reach);
  }

 private:
  const float* first_;
  std::size_t size_;
};

// Calls `change(strength)` for each step of the path, and for each step back when `both_ways`, that leads out
// of a row of the band. A path leaves a band rarely: a few steps are looked at together, and where they
// cannot be in it they are only added up.
template <bool both_ways, typename Change>
void for_each_strength_of(const Band& band, float* row, const RowSteps& steps,
                          std::span<const std::uint8_t> directions, Change change) {
  constexpr std::size_t together = 4;
  const std::ptrdiff_t reach = steps.reach(together);
  const auto change_own = [=](float& strength) {
    if (band.holds(&strength)) change(strength);
  };
  const auto ignore = [](const float*) {};
  for (; directions.size() >= together; directions = directions.subspan(together)) {
    const auto next = directions.first<together>();
    if (band.is_far_from(row, reach)) {
      std::ptrdiff_t way = 0;
      for (const std::size_t direction : next) way += steps.on[direction];
      row += way;
    } else if (band.holds_around(row, reach)) {
      row = for_each_strength<both_ways>(row, steps, next, change, ignore);
    } else {
      row = for_each_strength<both_ways>(row, steps, next, change_own, ignore);
    }
  }
  for_each_strength<both_ways>(row, steps, directions, change_own, ignore);
}

}  // namespace pathrace::algorithms
