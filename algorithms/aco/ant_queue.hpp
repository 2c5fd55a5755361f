// Ants that wait to be walked, each handed out once.
#pragma once

#include <atomic>
#include <cstddef>

#include "algorithms/aco/ring.hpp"

namespace pathrace::algorithms {

/// Some ants of an iteration, every `stride`-th of a range. Every walker has a queue, on two cache lines of
/// its own (processors fetch pairs of them), and the queues form a ring: whose own is empty takes from the
/// next. So nobody runs out of ants while another has a heap of them, and until then no two cores want the
/// same line.
class alignas(128) AntQueue : public Ring<AntQueue> {
 public:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  AntQueue() = default;
  AntQueue(std::size_t begin, std::size_t end) { fill(begin, end); }

  /// While nobody takes.
  void fill(std::size_t begin, std::size_t end, std::size_t stride = 1) {
    next_.store(begin, std::memory_order_relaxed);
    end_ = end;
    stride_ = stride;
  }
  /// An ant, or `none` when all are handed out.
  std::size_t take() {
    const std::size_t ant = take_own();
    return ant != none ? ant : take_from_others();
  }

 private:
  std::size_t take_own() {
    if (next_.load(std::memory_order_relaxed) >= end_) return none;
    const std::size_t ant = next_.fetch_add(stride_, std::memory_order_relaxed);
    return ant < end_ ? ant : none;
  }

  // Rare, and to be kept out of the walkers' loop.
  [[gnu::noinline]] std::size_t take_from_others() {
    for (AntQueue* queue = next(); queue != this; queue = queue->next()) {
      const std::size_t ant = queue->take_own();
      if (ant != none) return ant;
    }
    return none;
  }

  std::atomic<std::size_t> next_{0};
  std::size_t end_ = 0;
  std::size_t stride_ = 1;
};

}  // namespace pathrace::algorithms
