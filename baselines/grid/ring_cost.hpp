// Costs of lattice paths as single integers, in the order of the exact lengths.
//
// A straight step costs q, a diagonal one p, where p/q is a convergent of sqrt 2 from Pell's equation
// (p^2 - 2 q^2 = 1). Two lengths a + b sqrt 2 and c + d sqrt 2 that differ do so by at least 1 / (3 N) when
// all counts are at most N, while p b / q is wrong by b / (2.8 q^2) only; so for N <= q the integers a q + b
// p have exactly the order of the lengths, and are equal when they are. q = 15,994,428 covers every path on a
// grid of 2^24 cells, and such a path's cost fits 48 bits.
#pragma once

#include <cstdint>
#include <cstdlib>

#include "core/lattice_length.hpp"
#include "core/moves.hpp"

namespace pathrace::baselines {

using RingCost = std::uint64_t;

inline constexpr RingCost straight_cost = 15'994'428;
inline constexpr RingCost diagonal_cost = 22'619'537;
static_assert(diagonal_cost * diagonal_cost - 2 * straight_cost * straight_cost == 1);

constexpr RingCost step_cost(int direction) {
  return is_diagonal(direction) ? diagonal_cost : straight_cost;
}

/// The counts of steps that cost this much: p^2 = 1 modulo q, so p times the cost gives back the number of
/// diagonal steps modulo q.
constexpr LatticeLength lattice_length(RingCost cost) {
  const RingCost diagonal = cost % straight_cost * (diagonal_cost % straight_cost) % straight_cost;
  return {static_cast<std::int64_t>((cost - diagonal * diagonal_cost) / straight_cost),
          static_cast<std::int64_t>(diagonal)};
}

/// Length of a shortest path between two cells of an empty map.
struct OctileDistance {
  RingCost operator()(int dx, int dy) const {
    const auto x = static_cast<RingCost>(std::abs(dx));
    const auto y = static_cast<RingCost>(std::abs(dy));
    return x > y ? diagonal_cost * y + straight_cost * (x - y) : diagonal_cost * x + straight_cost * (y - x);
  }
};

struct ManhattanDistance {
  RingCost operator()(int dx, int dy) const {
    return straight_cost * static_cast<RingCost>(std::abs(dx) + std::abs(dy));
  }
};

struct ZeroDistance {
  RingCost operator()(int, int) const { return 0; }
};

}  // namespace pathrace::baselines
