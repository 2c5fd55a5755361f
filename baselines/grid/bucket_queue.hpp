// A priority queue for costs that rise by little: a ring of stacks.
//
// Bucket k holds the entries whose f lies in [k w, (k + 1) w) above the first f, with w = 2^23, about 0.52
// cell edges. With a consistent heuristic a step raises f by at most two diagonal steps, 5.4 buckets, so
// eight buckets in a ring suffice and no bucket before the current one is ever pushed to. Inside a bucket the
// order is last in, first out; whoever improves a cell pushes it again, so the order never costs optimality.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "baselines/grid/ring_cost.hpp"

namespace pathrace::baselines {

class BucketQueue {
 public:
  void restart(RingCost first) {
    for (auto& bucket : buckets_) bucket.clear();
    base_ = first;
    current_ = 0;
    size_ = 0;
  }

  bool empty() const { return size_ == 0; }

  void push(RingCost f, std::uint32_t entry) {
    buckets_[((f - base_) >> width_bits) & ring_mask].push_back(entry);
    ++size_;
  }

  /// Expects a non-empty queue.
  std::uint32_t pop() {
    while (buckets_[current_ & ring_mask].empty()) ++current_;
    auto& bucket = buckets_[current_ & ring_mask];
    const std::uint32_t entry = bucket.back();
    bucket.pop_back();
    --size_;
    return entry;
  }

  /// True while entries of the bucket that was popped last remain.
  bool current_bucket_has_more() const { return !buckets_[current_ & ring_mask].empty(); }

 private:
  static constexpr int width_bits = 23;
  static constexpr std::size_t ring_mask = 7;
  static_assert(2 * diagonal_cost < (ring_mask << width_bits));

  std::array<std::vector<std::uint32_t>, ring_mask + 1> buckets_;
  RingCost base_ = 0;
  std::size_t current_ = 0;
  std::size_t size_ = 0;
};

}  // namespace pathrace::baselines
