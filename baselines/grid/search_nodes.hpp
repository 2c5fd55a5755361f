// What a search knows about each cell of a map, in 8 bytes per padded cell.
//
// From the highest bit: 12 bits of generation, 48 bits of cost, one bit "expanded", 3 bits for the direction
// of the step that led here; on large maps 6 bits of generation, 54 of cost. Generations count down from
// query to query, so that every node of an older query is greater than any of the present one: "unseen, or
// seen at more cost" is one comparison, and a new query costs nothing.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "baselines/grid/ring_cost.hpp"
#include "core/checkpoint.hpp"

namespace pathrace::baselines {

template <typename Ring = SmallRing>
class SearchNodes {
 public:
  explicit SearchNodes(std::size_t cells)
      : nodes_(filled_gradually<std::vector<std::uint64_t>>(cells, unseen)) {}

  /// Forgets every cell.
  void restart() {
    if (generation_ == 0) {
      std::fill(nodes_.begin(), nodes_.end(), unseen);
      generation_ = generation_count;
    }
    --generation_;
  }

  /// Notes that this cell is reached at this cost by a step in this direction, unless it is known to be
  /// reached at no more. True when it was news; the cell then counts as not expanded.
  bool reach(std::size_t index, RingCost cost, unsigned direction) {
    const std::uint64_t node = generation_ << generation_shift | cost << cost_shift | direction;
    if (nodes_[index] <= (node | low_bits)) return false;
    nodes_[index] = node;
    return true;
  }

  bool seen(std::size_t index) const { return nodes_[index] >> generation_shift == generation_; }
  /// The following expect a cell that has been seen.
  bool expanded(std::size_t index) const { return (nodes_[index] & expanded_bit) != 0; }
  void mark_expanded(std::size_t index) { nodes_[index] |= expanded_bit; }
  RingCost cost(std::size_t index) const { return nodes_[index] >> cost_shift & cost_mask; }
  unsigned direction(std::size_t index) const {
    return static_cast<unsigned>(nodes_[index] & direction_mask);
  }

 private:
  static constexpr std::uint64_t unseen = ~std::uint64_t{0};
  static constexpr int cost_shift = 4;
  static constexpr int generation_shift = cost_shift + Ring::cost_bits;
  // The last generation itself means unseen.
  static constexpr std::uint64_t generation_count = (std::uint64_t{1} << (64 - generation_shift)) - 1;
  static constexpr std::uint64_t cost_mask = (std::uint64_t{1} << Ring::cost_bits) - 1;
  static constexpr std::uint64_t expanded_bit = 8;
  static constexpr std::uint64_t direction_mask = 7;
  static constexpr std::uint64_t low_bits = 15;

  std::vector<std::uint64_t> nodes_;
  std::uint64_t generation_ = generation_count;
};

}  // namespace pathrace::baselines
