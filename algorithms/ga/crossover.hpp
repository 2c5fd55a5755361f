// One-point crossover of two chromosomes of different length.
//
// Both are cut once and change their tails: first until its cut + second behind its cut, and the other way
// round. `common` prefers a cell that both visit between start and goal, so that paths without gaps have
// children without gaps [I]; without one, and with `free`, each is cut behind a random inner gene of its own
// [I]. Chromosomes without inner genes are not cut.
//
// Xie, Yu, 2010, section 2.4 ("one point"; which points is not said, algorithms.md 5.1).
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "algorithms/ga/place_table.hpp"
#include "core/names.hpp"
#include "core/stream.hpp"

namespace pathrace::algorithms {

enum class CrossoverPoint { common, free };

/// Positions of the last gene that each parent gives to its own child.
struct Cut {
  std::size_t first = 0;
  std::size_t second = 0;

  friend bool operator==(const Cut&, const Cut&) = default;
};

class Crossover {
 public:
  /// The table outlives the crossover and serves nobody else during a cut.
  Crossover(PlaceTable& places, CrossoverPoint point) : places_(places), point_(point) {}

  /// Makes room for chromosomes of so many genes.
  void reserve(std::size_t genes) { shared_.reserve(genes); }

  /// Nothing when a parent has no inner gene. Every common cell, or every pair of points, is equally likely.
  std::optional<Cut> cut(std::span<const Gene> first, std::span<const Gene> second, Stream& stream);

 private:
  PlaceTable& places_;
  CrossoverPoint point_;
  std::vector<Cut> shared_;
};

}  // namespace pathrace::algorithms

namespace pathrace {
template <>
inline constexpr auto names_of<algorithms::CrossoverPoint> =
    std::to_array<std::pair<algorithms::CrossoverPoint, std::string_view>>({
        {algorithms::CrossoverPoint::common, "common"},
        {algorithms::CrossoverPoint::free, "free"},
    });
}  // namespace pathrace
