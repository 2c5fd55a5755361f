// Ants under way that change walkers.
//
// Walks differ in length, and nobody knows beforehand by how much. So the last ants of an iteration are
// handed over: a walker whose ants are all back asks another, which gives away half of those that it walks
// side by side. An ant's walk is the same whoever walks it.
#pragma once

#include <atomic>
#include <cstddef>

#include "algorithms/aco/ring.hpp"

namespace pathrace::algorithms {

class Walker;

/// Every walker has one, on two cache lines of its own; those of walkers that may ask each other form a ring.
class alignas(128) HandOver : public Ring<HandOver> {
 public:
  explicit HandOver(Walker& walker) : walker_(walker) {}

  /// While it exists, others ask, and are answered at the end of it at the latest.
  class Open {
   public:
    explicit Open(HandOver& hand_over) : hand_over_(hand_over) {
      hand_over_.asking_.store(nullptr, std::memory_order_relaxed);
    }
    Open(const Open&) = delete;
    Open& operator=(const Open&) = delete;
    ~Open() { hand_over_.close(); }

   private:
    HandOver& hand_over_;
  };

  /// While open: is there a walker that asks?
  bool is_asked() const { return asking_.load(std::memory_order_relaxed) != nullptr; }
  /// While open: calls `give(walker)` for the one that asks, if there still is one; it waits. `give` returns
  /// how many ants it has given, and so does this.
  template <typename Give>
  std::size_t answer(const Give& give) {
    HandOver* const asking = asking_.exchange(nullptr, std::memory_order_acquire);
    if (asking == nullptr) return 0;
    const std::size_t given = give(asking->walker_);
    asking->given_.store(given, std::memory_order_release);
    return given;
  }

  /// Asks the others one after another, and waits for their answers. How many ants were given: to the lanes
  /// from the first on, none of which may be under way. 0 when nobody has any to give, or
  /// has answered after `patience` looks: an answer is due at once, and 500 looks are some ten microseconds.
  std::size_t ask(int patience = 500);

 private:
  static constexpr std::size_t no_answer = static_cast<std::size_t>(-1);

  void close() {
    HandOver* const asking = asking_.exchange(this, std::memory_order_acq_rel);
    if (asking != nullptr) asking->given_.store(0, std::memory_order_release);
  }
  std::size_t wait_for(HandOver& other, int& patience);

  Walker& walker_;
  std::atomic<HandOver*> asking_{this};  // nullptr: nobody asks; itself: closed
  std::atomic<std::size_t> given_{no_answer};
};

}  // namespace pathrace::algorithms
