// Exact length of a lattice path: so many straight steps of 1, so many diagonal steps of sqrt 2.
//
// Comparing a + b sqrt 2 with c + d sqrt 2 needs only integers: sqrt 2 is irrational, so the sign of
// (a - c) + (b - d) sqrt 2 follows from the signs of its parts and from comparing squares.
#pragma once

#include <compare>
#include <cstdint>
#include <numbers>

namespace pathrace {

struct LatticeLength {
  std::int64_t straight = 0;
  std::int64_t diagonal = 0;

  constexpr double value() const {
    return static_cast<double>(straight) + static_cast<double>(diagonal) * std::numbers::sqrt2;
  }

  friend constexpr LatticeLength operator+(LatticeLength a, LatticeLength b) {
    return {a.straight + b.straight, a.diagonal + b.diagonal};
  }
  friend constexpr bool operator==(const LatticeLength&, const LatticeLength&) = default;
  friend constexpr std::strong_ordering operator<=>(LatticeLength a, LatticeLength b) {
    const std::int64_t s = a.straight - b.straight;
    const std::int64_t d = a.diagonal - b.diagonal;
    if (s >= 0 && d >= 0) return s + d == 0 ? std::strong_ordering::equal : std::strong_ordering::greater;
    if (s <= 0 && d <= 0) return std::strong_ordering::less;
    const bool straight_outweighs = s * s > 2 * d * d;
    return straight_outweighs == (s > 0) ? std::strong_ordering::greater : std::strong_ordering::less;
  }
};

}  // namespace pathrace
