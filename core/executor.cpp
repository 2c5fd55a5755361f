#include "core/executor.hpp"

namespace pathrace {
namespace {

// A number for each thread of the process, never reused.
std::size_t thread_number() {
  static std::atomic<std::size_t> next{1};
  thread_local const std::size_t number = next.fetch_add(1, std::memory_order_relaxed);
  return number;
}

}  // namespace

void ThreadCensus::note() {
  const std::size_t me = thread_number();
  for (std::atomic<std::size_t>& slot : seen_) {
    std::size_t occupant = slot.load(std::memory_order_relaxed);
    if (occupant == me) return;
    if (occupant == 0 && slot.compare_exchange_strong(occupant, me, std::memory_order_relaxed)) {
      count_.fetch_add(1, std::memory_order_relaxed);
      return;
    }
    if (occupant == me) return;
  }
}

void ThreadCensus::clear() {
  for (std::atomic<std::size_t>& slot : seen_) slot.store(0, std::memory_order_relaxed);
  count_.store(0, std::memory_order_relaxed);
}

}  // namespace pathrace
