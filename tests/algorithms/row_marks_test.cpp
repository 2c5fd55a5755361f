// Marks on rows: a set of numbers, listed in ascending order.
#include "algorithms/aco/row_marks.hpp"

#include <gtest/gtest.h>

#include <set>
#include <vector>

#include "core/stream.hpp"

namespace pathrace::algorithms {
namespace {

constexpr std::size_t room = 300;

std::vector<std::uint32_t> rows_of(const RowMarks& marks) {
  std::vector<std::uint32_t> rows(room);
  rows.resize(static_cast<std::size_t>(marks.list(rows.data()) - rows.data()));
  return rows;
}

TEST(RowMarks, ListEachRowOfTheSetOnce) {
  RowMarks marks(20);
  EXPECT_TRUE(rows_of(marks).empty());
  for (const std::size_t row : {19U, 0U, 7U, 8U, 7U}) marks.add(row);
  EXPECT_EQ(rows_of(marks), (std::vector<std::uint32_t>{0, 7, 8, 19}));
  marks.clear();
  EXPECT_TRUE(rows_of(marks).empty());
}

TEST(RowMarks, AnAdderAddsToTheSet) {
  RowMarks marks(9);
  const auto add = marks.adder();
  add(8);
  add(2);
  EXPECT_EQ(rows_of(marks), (std::vector<std::uint32_t>{2, 8}));
}

TEST(RowMarks, TwoSetsChangePlaces) {
  RowMarks one(9);
  RowMarks other(9);
  one.add(3);
  one.swap(other);
  EXPECT_TRUE(rows_of(one).empty());
  EXPECT_EQ(rows_of(other), (std::vector<std::uint32_t>{3}));
}

TEST(RowMarks, AreEqualWhenTheirRowsAre) {
  RowMarks one(70);
  RowMarks other(70);
  EXPECT_EQ(one, other);
  one.add(69);
  EXPECT_NE(one, other);
  other.add(69);
  EXPECT_EQ(one, other);
}

TEST(RowMarks, AllRowsAreAsIfEachWereAdded) {
  RowMarks marks(128);
  marks.add_all();
  RowMarks expected(128);
  for (std::size_t row = 0; row < 128; ++row) expected.add(row);
  EXPECT_EQ(marks, expected);
}

TEST(RowMarks, EveryPatternOfNeighboursIsRead) {
  for (unsigned pattern = 0; pattern < 256; ++pattern) {
    RowMarks marks(150);
    std::vector<std::uint32_t> expected;
    for (unsigned bit = 0; bit < 8; ++bit) {
      if ((pattern >> bit & 1U) == 0) continue;
      marks.add(136 + bit);
      expected.push_back(136 + bit);
    }
    EXPECT_EQ(rows_of(marks), expected) << pattern;
  }
}

TEST(RowMarks, HoldAnySetOfAnySize) {
  Stream stream(1);
  for (int size = 0; size < static_cast<int>(room); ++size) {
    RowMarks marks(static_cast<std::size_t>(size));
    std::set<std::uint32_t> expected;
    for (int k = 0; k < size; ++k) {
      const auto row = static_cast<std::uint32_t>(stream.between(0, size - 1));
      if (stream.uniform() < 0.5) continue;
      marks.add(row);
      expected.insert(row);
    }
    EXPECT_EQ(rows_of(marks), std::vector<std::uint32_t>(expected.begin(), expected.end())) << size;
  }
}

}  // namespace
}  // namespace pathrace::algorithms
