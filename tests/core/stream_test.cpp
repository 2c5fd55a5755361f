// The random streams: published vectors of both generators, pinned first draws, and the properties of the
// tree and of our own distributions. Chi-square limits are the 99.99 % points; seeds are fixed, so a test
// either always passes or never does.

#include "core/stream.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <climits>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <vector>

namespace pathrace {
namespace {

double chi_square(const std::vector<int>& counts, int draws) {
  const double expected = static_cast<double>(draws) / static_cast<double>(counts.size());
  double sum = 0;
  for (const int count : counts) sum += (count - expected) * (count - expected) / expected;
  return sum;
}

// Test vector of the reference implementation of SplitMix64, seed 1234567.
TEST(Stream, KeysComeFromSplitMix64) {
  std::uint64_t state = 1234567;
  for (const std::uint64_t expected : {6457827717110365317U, 3203168211198807973U, 9817491932198370423U,
                                       4593380528125082431U, 16408922859458223821U}) {
    EXPECT_EQ(mix64(state += golden_gamma), expected);
  }
}

// Test vector of the reference implementation of xoshiro256++, state 1, 2, 3, 4.
TEST(Stream, DrawsComeFromXoshiro256PlusPlus) {
  std::array<std::uint64_t, 4> state = {1, 2, 3, 4};
  for (const std::uint64_t expected : {41943041U, 58720359U}) EXPECT_EQ(Stream::advance(state), expected);
  for (const std::uint64_t expected :
       {3588806011781223U, 3591011842654386U, 9228616714210784205U, 9973669472204895162U}) {
    EXPECT_EQ(Stream::advance(state), expected);
  }
}

// Pinned: every stored result depends on these numbers. They come from a separate transcription of the two
// generators; those of Stream(0) are also the published ones of xoshiro256++ seeded with 0 by SplitMix64.
TEST(Stream, FirstDrawsArePinned) {
  Stream root(0);
  for (const std::uint64_t expected :
       {5987356902031041503U, 7051070477665621255U, 6633766593972829180U, 211316841551650330U}) {
    EXPECT_EQ(root.bits(), expected);
  }
  Stream child = Stream(1).fork(0);
  EXPECT_EQ(child.place(), 5206558337466748783U);
  for (const std::uint64_t expected :
       {9717699766623145326U, 15889973001387858099U, 11493931677535447157U, 5921627898714576465U}) {
    EXPECT_EQ(child.bits(), expected);
  }
}

TEST(Stream, ForkDoesNotDependOnHowManyNumbersTheParentDrew) {
  Stream parent(7);
  const std::uint64_t expected = parent.fork(3).bits();
  for (int i = 0; i < 100; ++i) parent.bits();
  EXPECT_EQ(parent.fork(3).bits(), expected);
}

TEST(Stream, ForkDoesNotAdvanceTheParent) {
  Stream forked(7);
  Stream untouched(7);
  (void)forked.fork(0);
  (void)forked.fork("name");
  EXPECT_EQ(forked.bits(), untouched.bits());
}

TEST(Stream, ParentsChildrenAndGrandchildrenAreAllDifferent) {
  std::set<std::uint64_t> places;
  std::set<std::uint64_t> draws;
  std::size_t streams = 0;
  const auto meet = [&](Stream stream) {
    ++streams;
    places.insert(stream.place());
    draws.insert(stream.bits());
  };
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Stream root(seed);
    meet(root);
    for (std::uint64_t i = 0; i < 100; ++i) {
      meet(root.fork(i));
      for (std::uint64_t j = 0; j < 10; ++j) meet(root.fork(i).fork(j));
    }
  }
  EXPECT_EQ(places.size(), streams);
  EXPECT_EQ(draws.size(), streams);
}

TEST(Stream, TheOrderOfForksMatters) {
  EXPECT_NE(Stream(1).fork(2).fork(3).place(), Stream(1).fork(3).fork(2).place());
}

TEST(Stream, NamedChildrenDifferFromEachOtherAndFromNumberedOnes) {
  const Stream root(5);
  const std::set<std::uint64_t> places = {root.fork("ants").place(), root.fork("ant").place(),
                                          root.fork("").place(), root.fork(0).place(), root.place()};
  EXPECT_EQ(places.size(), 5U);
  EXPECT_EQ(root.fork("ants").place(), Stream(5).fork("ants").place());
}

// Two unrelated words differ in 32 of 64 bits on average, standard deviation 4. Over 4096 pairs the sum has
// mean 131072 and deviation 256; six deviations are allowed.
TEST(Stream, SiblingsAreUncorrelatedFromTheFirstDraw) {
  const Stream root(11);
  int siblings = 0;
  int parent_and_child = 0;
  for (std::uint64_t i = 0; i < 4096; ++i) {
    const std::uint64_t draw = root.fork(i).bits();
    siblings += std::popcount(draw ^ root.fork(i + 1).bits());
    parent_and_child += std::popcount(Stream(i).bits() ^ Stream(i).fork(0).bits());
  }
  EXPECT_NEAR(siblings, 131072, 6 * 256);
  EXPECT_NEAR(parent_and_child, 131072, 6 * 256);
}

TEST(Stream, UniformIsTheUpper53BitsOfADrawBelowOne) {
  Stream stream(3);
  Stream same(3);
  double sum = 0;
  for (int i = 0; i < 100000; ++i) {
    const double value = stream.uniform();
    ASSERT_EQ(value, std::ldexp(static_cast<double>(same.bits() / 2048), -53));
    ASSERT_GE(value, 0.0);
    ASSERT_LT(value, 1.0);
    sum += value;
  }
  EXPECT_NEAR(sum / 100000, 0.5, 6 * 0.288675 / std::sqrt(100000.0));
}

// 53 bits are what a double below 1 holds; 24 for a float. A wider draw would round up to 1.
TEST(Stream, UniformFloatIsTheUpper24BitsOfADrawBelowOne) {
  Stream stream(3);
  Stream same(3);
  for (int i = 0; i < 100000; ++i) {
    const float value = stream.uniform_float();
    ASSERT_EQ(value, std::ldexp(static_cast<float>(same.bits() >> 40), -24));
    ASSERT_LT(value, 1.0F);
  }
}

TEST(Stream, BelowReachesEveryValueEquallyOften) {
  Stream stream(17);
  std::vector<int> counts(7);
  for (int i = 0; i < 70000; ++i) ++counts.at(stream.below(7));
  EXPECT_LT(chi_square(counts, 70000), 27.9);  // 6 degrees of freedom
}

TEST(Stream, BelowOneIsZero) {
  Stream stream(17);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(stream.below(1), 0U);
}

// With 3 * 2^62 values, four draws fall on three values: without rejection the remainder 0 would come half
// of the time, and a plain modulo would put half of the draws into the first third.
TEST(Stream, BelowIsUnbiasedWhereTheCountDoesNotDivideTheRange) {
  const std::uint64_t count = std::uint64_t{3} << 62;
  Stream stream(19);
  std::vector<int> remainders(3);
  std::vector<int> thirds(3);
  for (int i = 0; i < 30000; ++i) {
    const std::uint64_t value = stream.below(count);
    ++remainders.at(value % 3);
    ++thirds.at(value >> 62);
  }
  EXPECT_LT(chi_square(remainders, 30000), 18.4);  // 2 degrees of freedom
  EXPECT_LT(chi_square(thirds, 30000), 18.4);
}

TEST(Stream, BetweenIncludesBothEnds) {
  Stream stream(23);
  std::map<int, int> seen;
  for (int i = 0; i < 1000; ++i) ++seen[stream.between(-2, 2)];
  EXPECT_EQ(seen.size(), 5U);
  EXPECT_EQ(seen.begin()->first, -2);
  EXPECT_EQ(seen.rbegin()->first, 2);
  EXPECT_EQ(stream.between(4, 4), 4);
}

TEST(Stream, BetweenCoversTheWholeRangeOfInt) {
  Stream stream(29);
  int negative = 0;
  int upper_half = 0;
  for (int i = 0; i < 4000; ++i) {
    const int value = stream.between(INT_MIN, INT_MAX);
    negative += value < 0 ? 1 : 0;
    upper_half += value > INT_MAX / 2 ? 1 : 0;
  }
  EXPECT_NEAR(negative, 2000, 6 * 31.7);
  EXPECT_NEAR(upper_half, 1000, 6 * 27.4);
}

TEST(Stream, ChanceZeroNeverHappensAndChanceOneAlways) {
  Stream stream(31);
  for (int i = 0; i < 10000; ++i) {
    ASSERT_FALSE(stream.chance(0));
    ASSERT_TRUE(stream.chance(1));
  }
}

TEST(Stream, ShuffleIsAPermutation) {
  Stream stream(37);
  for (std::size_t size : {0U, 1U, 100U}) {
    std::vector<std::size_t> items(size);
    for (std::size_t i = 0; i < size; ++i) items[i] = i;
    const std::vector<std::size_t> sorted = items;
    stream.shuffle(items);
    EXPECT_TRUE(std::is_permutation(items.begin(), items.end(), sorted.begin(), sorted.end()));
    EXPECT_EQ(items == sorted, size < 2) << size;
  }
}

TEST(Stream, ShuffleGivesEachOrderEquallyOften) {
  Stream stream(41);
  std::map<std::vector<int>, int> orders;
  for (int i = 0; i < 24000; ++i) {
    std::vector<int> items = {0, 1, 2, 3};
    stream.shuffle(items);
    ++orders[items];
  }
  ASSERT_EQ(orders.size(), 24U);
  std::vector<int> counts;
  for (const auto& order : orders) counts.push_back(order.second);
  EXPECT_LT(chi_square(counts, 24000), 56.0);  // 23 degrees of freedom
}

}  // namespace
}  // namespace pathrace
