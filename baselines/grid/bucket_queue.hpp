// A priority queue for costs that rise by little: a ring of stacks.
//
// Bucket k holds the entries whose f lies in [k w, (k + 1) w) above the first f, with w = 2^bucket_bits, 0.52
// or 0.72 cell edges. With a consistent heuristic a step raises f by at most two diagonal steps, 5.4 buckets,
// so eight buckets in a ring suffice and no bucket before the current one is ever pushed to. Inside a bucket
// the order is last in, first out; whoever improves a cell pushes it again, so the order never costs
// optimality.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "baselines/grid/ring_cost.hpp"

namespace pathrace::baselines {

template <typename Ring = SmallRing>
class BucketQueue {
 public:
  void restart(RingCost first) {
    for (Stack& bucket : buckets_) bucket.size = 0;
    base_ = first;
    current_ = 0;
  }

  void push(RingCost f, std::uint32_t entry) {
    Stack& bucket = buckets_[((f - base_) >> width_bits) & ring_mask];
    if (bucket.size == bucket.entries.size()) bucket.entries.resize(2 * bucket.size + 64);
    bucket.entries[bucket.size++] = entry;
  }

  /// True while entries of the current bucket remain.
  bool current_bucket_has_more() const { return buckets_[current_].size > 0; }

  /// The last entry of the current bucket. Expects that there is one.
  std::uint32_t pop() {
    Stack& bucket = buckets_[current_];
    return bucket.entries[--bucket.size];
  }

  /// Makes the next bucket that is not empty the current one; false when all are empty.
  bool advance() {
    for (std::size_t step = 0; step <= ring_mask; ++step) {
      if (current_bucket_has_more()) return true;
      current_ = (current_ + 1) & ring_mask;
    }
    return false;
  }

 private:
  static constexpr int width_bits = Ring::bucket_bits;
  static constexpr std::size_t ring_mask = 7;
  static_assert(2 * Ring::diagonal < (RingCost{ring_mask} << width_bits));

  struct Stack {
    std::vector<std::uint32_t> entries;  // the first `size` of them count
    std::size_t size = 0;
  };

  std::array<Stack, ring_mask + 1> buckets_;
  RingCost base_ = 0;
  std::size_t current_ = 0;  // in the ring
};

}  // namespace pathrace::baselines
