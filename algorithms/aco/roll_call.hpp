// Which ants of a round are back, for a thread that waits for them one after another.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pathrace::algorithms {

/// Each ant signs with the number of the round. Signatures stand apart from the walks, so that a walk that is
/// the same as in the round before need not be written, and its cache lines stay with all who have read them;
/// and ants that are dealt out to the same walker sign side by side, so that a look at one brings the others.
class RollCall {
 public:
  /// For ants 0..ants-1 that are dealt out in turn to so many walkers, 1 or more.
  RollCall(std::size_t ants, std::size_t walkers)
      : pages_(walkers * pages_for(ants, walkers)), places_(ants) {
    for (std::size_t ant = 0; ant < ants; ++ant) {
      const std::size_t row = ant / walkers;
      const std::size_t page = ant % walkers * pages_for(ants, walkers) + row / rows;
      places_[ant] = &pages_[page][row % rows];
    }
  }

  /// Publishes what the calling thread has written before.
  void sign(std::size_t ant, std::uint32_t round) { places_[ant]->store(round, std::memory_order_release); }
  /// True when this ant has signed in this round, which is any but 0; who asks then sees its walk.
  bool has(std::size_t ant, std::uint32_t round) const {
    return places_[ant]->load(std::memory_order_acquire) == round;
  }

 private:
  using Place = std::atomic<std::uint32_t>;

  // Two cache lines, which processors fetch together.
  static constexpr std::size_t rows = 128 / sizeof(Place);
  struct alignas(128) Page : std::array<Place, rows> {};

  static constexpr std::size_t pages_for(std::size_t ants, std::size_t walkers) {
    return (ants + walkers * rows - 1) / (walkers * rows);
  }

  std::vector<Page> pages_;
  std::vector<Place*> places_;  // of each ant
};

}  // namespace pathrace::algorithms
