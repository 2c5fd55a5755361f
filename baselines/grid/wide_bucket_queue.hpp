// A bucket queue for costs that may rise by as much as a jump over the whole map: a ring of linked stacks.
//
// Buckets are as wide as BucketQueue's. A push adds a link to a pool that only grows within a query; a bucket
// is the number of its top link.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "baselines/grid/ring_cost.hpp"

namespace pathrace::baselines {

template <typename Ring = SmallRing>
class WideBucketQueue {
 public:
  /// `rise`: the most that f rises from an entry popped to one pushed before the next pop.
  explicit WideBucketQueue(RingCost rise)
      : tops_(std::bit_ceil((rise >> width_bits) + 2), none), ring_mask_(tops_.size() - 1) {}

  void restart(RingCost first) {
    std::fill(tops_.begin(), tops_.end(), none);
    links_.clear();
    base_ = first;
    current_ = 0;
    size_ = 0;
  }

  void push(RingCost f, std::uint32_t entry) {
    std::uint32_t& top = tops_[((f - base_) >> width_bits) & ring_mask_];
    links_.push_back({entry, top});
    top = static_cast<std::uint32_t>(links_.size() - 1);
    ++size_;
  }

  bool empty() const { return size_ == 0; }

  /// The last entry of the lowest bucket. Expects a non-empty queue.
  std::uint32_t pop() {
    while (tops_[current_ & ring_mask_] == none) ++current_;
    std::uint32_t& top = tops_[current_ & ring_mask_];
    const Link link = links_[top];
    top = link.below;
    --size_;
    return link.entry;
  }

  /// No entry that is left has a smaller f than this.
  RingCost floor() const { return base_ + (current_ << width_bits); }

 private:
  static constexpr int width_bits = Ring::bucket_bits;
  static constexpr std::uint32_t none = 0xFFFFFFFF;

  struct Link {
    std::uint32_t entry;
    std::uint32_t below;
  };

  std::vector<std::uint32_t> tops_;
  std::size_t ring_mask_;
  std::vector<Link> links_;
  RingCost base_ = 0;
  std::size_t current_ = 0;
  std::size_t size_ = 0;
};

}  // namespace pathrace::baselines
