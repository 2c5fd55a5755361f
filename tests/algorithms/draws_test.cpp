#include "algorithms/draws.hpp"

#include <gtest/gtest.h>

#include <cstdint>

namespace pathrace::algorithms {
namespace {

// What a stream gives alone.
std::uint64_t nth(std::uint64_t seed, int n) {
  Stream stream(seed);
  for (int i = 1; i < n; ++i) stream.bits();
  return stream.bits();
}

TEST(Draws, EachColumnGivesWhatItsStreamGivesAlone) {
  for (const std::size_t count : {1U, 3U, 4U, 5U, 12U}) {
    Draws draws;
    for (std::size_t k = 0; k < count; ++k) draws.set(k, Stream(100 + k));
    for (int n = 1; n <= 50; ++n) {
      draws.advance(count);
      for (std::size_t k = 0; k < count; ++k) {
        ASSERT_EQ(draws.bits(k), nth(100 + k, n)) << "column " << k << " of " << count;
      }
    }
  }
}

TEST(Draws, AStreamGoesOnFromWhereItStands) {
  Stream stream(7);
  stream.bits();
  Draws draws;
  draws.set(5, stream);
  draws.advance(6);
  EXPECT_EQ(draws.bits(5), nth(7, 2));
}

TEST(Draws, AnotherDrawOfOneColumnLeavesTheOthersAlone) {
  Draws draws;
  draws.set(0, Stream(1));
  draws.set(1, Stream(2));
  draws.advance(2);
  EXPECT_EQ(draws.another(0), nth(1, 2));
  EXPECT_EQ(draws.bits(0), nth(1, 1));
  draws.advance(2);
  EXPECT_EQ(draws.bits(0), nth(1, 3));
  EXPECT_EQ(draws.bits(1), nth(2, 2));
}

TEST(Draws, AColumnThatMovesTakesItsDrawAndItsFutureAlong) {
  Draws draws;
  for (std::size_t k = 0; k < 6; ++k) draws.set(k, Stream(k));
  draws.advance(6);
  draws.move(5, 1);
  EXPECT_EQ(draws.bits(1), nth(5, 1));
  draws.advance(5);
  EXPECT_EQ(draws.bits(1), nth(5, 2));
  EXPECT_EQ(draws.bits(0), nth(0, 2));
}

}  // namespace
}  // namespace pathrace::algorithms
