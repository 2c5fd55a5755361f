// A team: threads that stay at hand for the loops of one other thread, their leader.
//
// To gather threads for a loop costs a microsecond or more; a colony's iteration on a small map lasts thirty.
// Here a loop costs what it takes a cache line to change cores and come back.
//
// The gate is one word: the number of the loop, whether it is open, and how many helpers are inside. A helper
// enters by adding itself while the gate is open, so the leader waits for nobody who has not come: on a busy
// machine it does all the work itself. Helpers watch the gate for a fraction of a millisecond, then sleep.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>

#include "bench/executors/chunks.hpp"

namespace pathrace::bench {

class Team {
 public:
  /// The leader's: runs every chunk, with whoever helps, and returns when all are done. What chunks throw
  /// stays in `chunks`.
  void run(Chunks& chunks);
  /// A helper's life: works on the leader's loops until it is dismissed.
  void serve();
  /// The leader's, once, outside loops: lets the helpers go.
  void dismiss();
  /// Anybody's: whether helpers come too late.
  bool is_dismissed() const { return (gate_.load(std::memory_order_relaxed) & dismissed) != 0; }

 private:
  static constexpr std::uint32_t helpers = 0x3FF;  // how many are inside
  static constexpr std::uint32_t open = 0x400;
  static constexpr std::uint32_t dismissed = 0x800;
  static constexpr std::uint32_t one_loop = 0x1000;  // numbers may wrap: who slept so long misses one loop

  void work(Chunks& chunks);
  /// The gate, as soon as something is due to a helper who has served loop `last`.
  std::uint32_t watch(std::uint32_t last) const;
  void leave();

  alignas(64) std::atomic<std::uint32_t> gate_{0};
  Chunks* chunks_ = nullptr;  // while the gate is open or somebody is inside
  std::atomic<std::size_t> next_{0};
};

}  // namespace pathrace::bench
