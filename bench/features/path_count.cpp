#include "bench/features/path_count.hpp"

#include <cmath>
#include <utility>
#include <vector>

#include "core/checkpoint.hpp"

namespace pathrace::bench {
namespace {

constexpr double log10_of_2 = 0.30102999566398119521;
constexpr double log10_of_e = 0.43429448190325182765;

// ln m = 2 artanh((m - 1) / (m + 1)); for m in [1/sqrt 2, sqrt 2] the square of that is below 0.0295, and
// twelve terms leave less than 1e-18.
double natural_log_near_1(double m) {
  const double z = (m - 1) / (m + 1);
  const double square = z * z;
  double sum = 0;
  for (int k = 23; k >= 1; k -= 2) sum = sum * square + 1.0 / k;
  return 2 * z * sum;
}

PathCount predecessors(const reference::DistanceField& field, const std::vector<PathCount>& counts,
                       std::size_t cell) {
  const LatticeLength here = *field.length_at(cell);
  PathCount sum;
  field.for_each_step(cell, [&](std::size_t before, bool diagonal) {
    const LatticeLength step = diagonal ? LatticeLength{0, 1} : LatticeLength{1, 0};
    const auto there = field.length_at(before);
    if (there && *there + step == here) sum.add(counts[before]);
  });
  return sum;
}

}  // namespace

void PathCount::add(PathCount other) {
  if (other.mantissa == 0) return;
  if (mantissa == 0) {
    *this = other;
    return;
  }
  if (other.exponent > exponent) std::swap(*this, other);
  if (exponent == other.exponent) {
    mantissa += other.mantissa;
  } else if (exponent == other.exponent + 1) {
    mantissa += other.mantissa * 0x1p-512;
  }  // else the smaller is below half a unit in the last place
  if (mantissa >= 0x1p512) {
    mantissa *= 0x1p-512;
    ++exponent;
  }
}

double PathCount::log10() const {
  int twos = 0;
  double m = std::frexp(mantissa, &twos);  // 0.5 <= m < 1, exact
  if (m < 0x1.6a09e667f3bcdp-1) {          // 1 / sqrt 2
    m *= 2;
    --twos;
  }
  const auto all_twos = static_cast<double>(exponent * 512 + twos);
  return all_twos * log10_of_2 + natural_log_near_1(m) * log10_of_e;
}

PathCount count_shortest_paths(const reference::DistanceField& field, const OccupancyGrid& grid, Cell cell) {
  std::vector<PathCount> counts(grid.padded_size());
  const std::size_t target = grid.index(cell);
  const std::vector<std::uint32_t>& order = field.order();
  counts[order.front()] = {1, 0};
  Pace pace;
  for (const std::uint32_t index : order) {
    pace.step();
    if (index != order.front()) counts[index] = predecessors(field, counts, index);
    if (index == target) break;
  }
  return counts[target];
}

}  // namespace pathrace::bench
