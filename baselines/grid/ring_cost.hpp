// Costs of lattice paths as single integers, in the order of the exact lengths.
//
// A straight step costs q, a diagonal one p, where p/q is a convergent of sqrt 2 from Pell's equation
// (p^2 - 2 q^2 = 1). Two lengths a + b sqrt 2 and c + d sqrt 2 that differ do so by at least 1 / (2.9 n), n =
// |b - d|, while p n / q is wrong by n / (2.8 q^2) only; so with at most q diagonal steps in a path the
// integers a q + b p have exactly the order of the lengths, and are equal when they are. There are two sizes
// of q, because the smaller one leaves more of a word to other things (search_nodes.hpp).
#pragma once

#include <cstdint>
#include <cstdlib>

#include "core/grid.hpp"
#include "core/lattice_length.hpp"
#include "core/moves.hpp"

namespace pathrace::baselines {

using RingCost = std::uint64_t;

/// `bits`: of the cost of any shortest path. `bucket`: buckets of queues are 2^bucket wide, about a cell
/// edge.
template <RingCost q, RingCost p, int bits, int bucket>
struct Ring {
  static constexpr RingCost straight = q;
  static constexpr RingCost diagonal = p;
  static constexpr int cost_bits = bits;
  static constexpr int bucket_bits = bucket;
  static_assert(p * p - 2 * q * q == 1);
};

/// Of maps with at most 2^24 cells.
using SmallRing = Ring<15'994'428, 22'619'537, 48, 23>;
/// Of any map: no two neighbours of a cell of a shortest path are on it beside the next and the one before,
/// so it covers at most two thirds of 2^27 cells, fewer than q.
using LargeRing = Ring<93'222'358, 131'836'323, 54, 26>;

inline bool fits_small_ring(const OccupancyGrid& grid) {
  return std::int64_t{grid.width()} * grid.height() <= std::int64_t{1} << 24;
}

inline constexpr RingCost straight_cost = SmallRing::straight;
inline constexpr RingCost diagonal_cost = SmallRing::diagonal;

template <typename Ring = SmallRing>
constexpr RingCost step_cost(int direction) {
  return is_diagonal(direction) ? Ring::diagonal : Ring::straight;
}

/// The counts of steps that cost this much: p^2 = 1 modulo q, so p times the cost gives back the number of
/// diagonal steps modulo q.
template <typename Ring = SmallRing>
constexpr LatticeLength lattice_length(RingCost cost) {
  constexpr RingCost q = Ring::straight;
  const RingCost diagonal = cost % q * (Ring::diagonal % q) % q;
  return {static_cast<std::int64_t>((cost - diagonal * Ring::diagonal) / q),
          static_cast<std::int64_t>(diagonal)};
}

/// Length of a shortest path between two cells of an empty map.
template <typename Ring = SmallRing>
struct OctileDistance {
  RingCost operator()(int dx, int dy) const {
    const auto x = static_cast<RingCost>(std::abs(dx));
    const auto y = static_cast<RingCost>(std::abs(dy));
    return x > y ? Ring::diagonal * y + Ring::straight * (x - y)
                 : Ring::diagonal * x + Ring::straight * (y - x);
  }
};

template <typename Ring = SmallRing>
struct ManhattanDistance {
  RingCost operator()(int dx, int dy) const {
    return Ring::straight * static_cast<RingCost>(std::abs(dx) + std::abs(dy));
  }
};

template <typename Ring = SmallRing>
struct ZeroDistance {
  RingCost operator()(int, int) const { return 0; }
};

}  // namespace pathrace::baselines
