// What an ant reads of the trail at a cell, and how to get from row to row.
#pragma once

#include <array>
#include <cstddef>

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

}  // namespace pathrace::algorithms
