// Copies that are asked for ahead of time are in the cache when they are read. A compiler may think that
// asking has no effect; this sees whether it is still there, by reading with and without it, side by side.
#ifdef __x86_64__

#include <gtest/gtest.h>
#include <immintrin.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "algorithms/aco/trail.hpp"
#include "core/stream.hpp"
#include "tests/algorithms/trail_field.hpp"

namespace pathrace::algorithms {
namespace {

constexpr int side = 60;

class TrailFetch : public ::testing::Test {
 protected:
  TrailFetch() {
    for (int y = 0; y < side; ++y) {
      for (int x = 0; x < side; ++x) cells.push_back(field.at(x, y));
    }
    Stream stream(1);
    for (std::size_t k = cells.size() - 1; k > 0; --k) {
      std::swap(cells[k], cells[static_cast<std::size_t>(stream.between(0, static_cast<int>(k)))]);
    }
    cells.resize(40);
    field.trail.keep_draft();
    for (const std::size_t cell : cells) field.trail.set(cell, 0, 1);
    EXPECT_TRUE(field.trail.begin_draft(1));
  }

  const float* copy(std::size_t index) const { return field.trail.rows_for_others()[index].strength.data(); }

  // Nanoseconds to read the cells' copies one after another, in an order that nobody can foresee.
  double time_to_read() const {
    float sum = 0;
    const auto begin = std::chrono::steady_clock::now();
    for (const std::size_t cell : cells) {
      const volatile float* const strength = copy(cell);
      sum = sum + *strength;
      _mm_lfence();
    }
    const std::chrono::duration<double, std::nano> time = std::chrono::steady_clock::now() - begin;
    EXPECT_EQ(sum, static_cast<float>(cells.size()));
    return time.count();
  }

  // The least time, which nothing else on the machine disturbed, where `ask` is called once the copies are in
  // no cache.
  template <typename Ask>
  double least_time_after(const Ask& ask) const {
    double least = std::numeric_limits<double>::infinity();
    for (int repetition = 0; repetition < 51; ++repetition) {
      for (const std::size_t cell : cells) _mm_clflush(copy(cell));
      _mm_mfence();
      ask();
      const auto begin = std::chrono::steady_clock::now();
      while (std::chrono::steady_clock::now() - begin < std::chrono::microseconds(100)) _mm_pause();
      least = std::min(least, time_to_read());
    }
    return least;
  }

  Field field{std::vector<std::string>(side, std::string(side, '.')), MoveRule::free, 1, 1, equal};
  std::vector<std::size_t> cells;
};

TEST_F(TrailFetch, CopiesThatAreAskedForHaveComeWhenTheyAreRead) {
  const double unasked = least_time_after([] {});
  EXPECT_LT(least_time_after([&] { field.trail.fetch_copies(); }), unasked / 2);
  EXPECT_LT(least_time_after([&] { field.trail.claim_copies(); }), unasked / 2);
}

}  // namespace
}  // namespace pathrace::algorithms

#endif
