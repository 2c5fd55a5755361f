#include "algorithms/aco/hand_over.hpp"

#include "core/pause.hpp"

namespace pathrace::algorithms {

std::size_t HandOver::ask(int patience) {
  bool others_ask = true;
  while (others_ask && patience > 0) {
    others_ask = false;
    for (HandOver* other = next(); other != this; other = other->next()) {
      HandOver* asking = other->asking_.load(std::memory_order_relaxed);
      if (asking == other) continue;
      given_.store(no_answer, std::memory_order_relaxed);
      if (asking != nullptr || !other->asking_.compare_exchange_strong(asking, this)) {
        others_ask = others_ask || asking != other;
        continue;
      }
      const std::size_t given = wait_for(*other, patience);
      if (given > 0) return given;
    }
    if (others_ask) {
      pause_briefly();
      --patience;
    }
  }
  return 0;
}

// Who does not answer for long is probably not running: there are more threads than processors. Once it has
// begun to answer, it cannot be left alone any more.
std::size_t HandOver::wait_for(HandOver& other, int& patience) {
  while (true) {
    const std::size_t given = given_.load(std::memory_order_acquire);
    if (given != no_answer) return given;
    pause_briefly();
    HandOver* self = this;
    if (--patience <= 0 && other.asking_.compare_exchange_strong(self, nullptr)) return 0;
  }
}

}  // namespace pathrace::algorithms
