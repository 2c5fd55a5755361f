// What an ant reads of the trail at a cell, and how to get from row to row.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "core/moves.hpp"

namespace pathrace::algorithms {

/// What an ant reads at a cell.
struct alignas(64) TrailRow {
  std::array<float, direction_count> strength;      ///< (stored tau)^alpha, below the limit perhaps
  std::array<float, direction_count> desirability;  ///< (eta / largest eta)^beta, 0 for closed steps
};

inline constexpr std::size_t floats_per_row = sizeof(TrailRow) / sizeof(float);

/// A step in each direction, as what it adds to a pointer to the first strength of its row.
struct RowSteps {
  explicit RowSteps(const MoveTable& moves) {
    for (int d = 0; d < direction_count; ++d) {
      const auto k = static_cast<std::size_t>(d);
      on[k] = moves.offset(d) * static_cast<std::ptrdiff_t>(floats_per_row);
      back[k] = on[k] + opposite(d);
    }
  }

  std::array<std::ptrdiff_t, direction_count> on;    ///< to the row it leads to
  std::array<std::ptrdiff_t, direction_count> back;  ///< and there to the step back
};

/// Changes a strength, within limits.
inline auto alteration(float kept, float added, float least, float most) {
  return [=](float& tau) { tau = std::min(std::max(std::max(tau, least) * kept + added, least), most); };
}

/// The same with kept = 1 and added >= 0: what is only added to cannot fall below the lower limit.
inline auto addition(float added, float least, float most) {
  return [=](float& tau) { tau = std::min(std::max(tau, least) + added, most); };
}

// Calls `visit(row)` for each row of the path, and `change(strength)` for each step, and for each step back
// when `both_ways`. `row` is where the path starts. What is called comes by value: a float that is stored
// could be a limit, if that were only referred to, and limits were then read anew for each step. Returns
// where the path ends.
template <bool both_ways, std::size_t count, typename Change, typename Visit>
float* for_each_strength(float* row, const RowSteps& steps, std::span<const std::uint8_t, count> directions,
                         Change change, Visit visit) {
  for (const std::size_t direction : directions) {
    visit(row);
    change(row[direction]);
    if (both_ways) change(row[steps.back[direction]]);
    row += steps.on[direction];
  }
  visit(row);
  return row;
}

}  // namespace pathrace::algorithms
