#include "results/median.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace pathrace::results {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

TEST(Median, IsTheMiddleValueOfAnOddCount) {
  EXPECT_EQ(median({7}), 7);
  EXPECT_EQ(median({9, 1, 5}), 5);
  EXPECT_EQ(median({3, -2, 8, 100, 4}), 4);
}

TEST(Median, IsTheMeanOfTheTwoMiddleValuesOfAnEvenCount) {
  EXPECT_EQ(median({1, 2}), 1.5);
  EXPECT_EQ(median({10, 1, 4, 2}), 3);  // 1 2 4 10
  EXPECT_EQ(median({5, 5, 1, 9, 9, 1}), 5);
}

TEST(Median, IsInfiniteWhenHalfOfAnEvenCountIs) {
  EXPECT_EQ(median({1, infinite}), infinite);
  EXPECT_EQ(median({infinite, infinite}), infinite);
  EXPECT_EQ(median({infinite, 1, 2}), 2);
}

TEST(Median, OfTheLargestNumbersDoesNotOverflow) {
  const double largest = std::numeric_limits<double>::max();
  EXPECT_EQ(median({largest, largest}), largest);
}

TEST(Median, OfNothingIsAnError) {
  EXPECT_THROW(median({}), std::invalid_argument);
}

}  // namespace
}  // namespace pathrace::results
