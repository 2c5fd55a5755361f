#include "bench/executors/team.hpp"

#include "core/pause.hpp"

namespace pathrace::bench {
namespace {

constexpr int patience = 20000;  // looks before sleep, 10 to 40 ns each

// Returns the word once it is as wished: looks for a while, then sleeps between changes.
template <typename Wished>
std::uint32_t await(const std::atomic<std::uint32_t>& word, const Wished& wished) {
  std::uint32_t value = word.load(std::memory_order_acquire);
  for (int looks = 0; !wished(value); value = word.load(std::memory_order_acquire)) {
    if (++looks < patience) {
      pause_briefly();
    } else {
      word.wait(value, std::memory_order_acquire);
    }
  }
  return value;
}

}  // namespace

void Team::run(Chunks& chunks) {
  chunks_ = &chunks;
  next_.store(1, std::memory_order_relaxed);  // chunk 0 is the leader's
  const std::uint32_t loop = gate_.load(std::memory_order_relaxed) + one_loop;
  gate_.store(loop | open, std::memory_order_seq_cst);
  gate_.notify_all();
  if (chunks.size() > 0) chunks.run(0);
  work(chunks);
  gate_.fetch_and(~open, std::memory_order_acq_rel);
  await(gate_, [](std::uint32_t gate) { return (gate & helpers) == 0; });
}

void Team::work(Chunks& chunks) {
  const std::size_t size = chunks.size();
  for (std::size_t k = next_.fetch_add(1, std::memory_order_relaxed); k < size;
       k = next_.fetch_add(1, std::memory_order_relaxed)) {
    chunks.run(k);
  }
}

void Team::serve() {
  constexpr std::uint32_t number = ~(one_loop - 1);
  std::uint32_t last = 0;
  while (true) {
    std::uint32_t gate = watch(last);
    if ((gate & dismissed) != 0) return;
    if (!gate_.compare_exchange_strong(gate, gate + 1, std::memory_order_acquire)) continue;
    last = gate & number;
    work(*chunks_);
    leave();
  }
}

std::uint32_t Team::watch(std::uint32_t last) const {
  return await(gate_, [last](std::uint32_t gate) {
    const bool fresh = (gate & open) != 0 && (gate & ~(one_loop - 1)) != last;
    return fresh || (gate & dismissed) != 0;
  });
}

void Team::leave() {
  const std::uint32_t before = gate_.fetch_sub(1, std::memory_order_release);
  if ((before & helpers) == 1 && (before & open) == 0) gate_.notify_all();
}

void Team::dismiss() {
  gate_.fetch_or(dismissed, std::memory_order_seq_cst);
  gate_.notify_all();
}

}  // namespace pathrace::bench
