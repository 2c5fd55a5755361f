#include "algorithms/aco/hand_over.hpp"

#include <thread>

namespace pathrace::algorithms {
namespace {

constexpr int looks_in_a_row = 1000;  // tens of microseconds: an answer comes within one step of each lane

void pause() {
#ifdef __x86_64__
  _mm_pause();
#endif
}

}  // namespace

std::size_t HandOver::ask() {
  bool others_ask = true;
  while (others_ask) {
    others_ask = false;
    for (HandOver* other = neighbour_; other != this; other = other->neighbour_) {
      HandOver* asking = other->asking_.load(std::memory_order_relaxed);
      if (asking == other) continue;
      given_.store(no_answer, std::memory_order_relaxed);
      if (asking != nullptr || !other->asking_.compare_exchange_strong(asking, this)) {
        others_ask = others_ask || asking != other;
        continue;
      }
      const std::size_t given = wait_for_answer();
      if (given > 0) return given;
    }
    if (others_ask) pause();
  }
  return 0;
}

// Threads may be more than processors: then who is asked may have to wait for this one's.
std::size_t HandOver::wait_for_answer() const {
  for (int looks = 1;; ++looks) {
    const std::size_t given = given_.load(std::memory_order_acquire);
    if (given != no_answer) return given;
    pause();
    if (looks % looks_in_a_row == 0) std::this_thread::yield();
  }
}

}  // namespace pathrace::algorithms
