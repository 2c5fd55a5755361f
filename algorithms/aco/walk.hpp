// A walk: what an ant brings home. Directions of its steps from the start, one byte each.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "algorithms/aco/nest.hpp"
#include "core/lattice_length.hpp"
#include "core/path.hpp"

namespace pathrace::algorithms {

/// A step of the grid: from the cell with this padded index in this direction.
struct Step {
  std::uint32_t index = 0;
  std::uint8_t direction = 0;

  friend bool operator==(const Step&, const Step&) = default;
};

/// Two cache lines, which processors fetch together: neighbours in a vector share neither. The thread that
/// deposits for all reads the first one only, unless the rule asks for more.
struct alignas(128) Walk {
  bool arrived = false;
  std::vector<std::uint8_t>
      directions;               ///< of the path; of an ant that died, only where the rule asks for it
  LatticeLength length;         ///< of the path
  std::uint64_t decisions = 0;  ///< steps forwards, backwards or onto a visited cell
  std::uint64_t pops = 0;       ///< steps backwards
  int turns = 0;             ///< steps in another direction than the one before, where the rule asks for it
  std::vector<Step> popped;  ///< steps taken back, in this order, only where the rule asks for it

  friend bool operator==(const Walk&, const Walk&) = default;
};
static_assert(offsetof(Walk, pops) + sizeof(Walk::pops) <= 64);

/// Steps in another direction than the one before.
int turns_of(const std::vector<std::uint8_t>& directions);
LatticeLength length_of(const std::vector<std::uint8_t>& directions);
/// Padded indices from the start, the last cell included.
std::vector<std::uint32_t> cells_of(const Nest& nest, const Walk& walk);
Path path_of(const Nest& nest, const Walk& walk);

/// Calls `visit(index, direction)` for each step of the path.
template <typename Visit>
void for_each_step(const Nest& nest, const Walk& walk, const Visit& visit) {
  std::size_t index = nest.start();
  for (const std::uint8_t direction : walk.directions) {
    visit(index, int{direction});
    index = nest.moves().step(index, direction);
  }
}

}  // namespace pathrace::algorithms
