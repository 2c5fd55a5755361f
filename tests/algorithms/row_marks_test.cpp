// Marks on rows: a set of numbers, of which each is visited once.
#include "algorithms/aco/row_marks.hpp"

#include <gtest/gtest.h>

#include <set>
#include <vector>

#include "core/stream.hpp"

namespace pathrace::algorithms {
namespace {

std::vector<std::size_t> rows_of(const RowMarks& marks) {
  std::vector<std::size_t> rows;
  marks.for_each([&](std::size_t row) { rows.push_back(row); });
  return rows;
}

TEST(RowMarks, VisitsEachRowOfTheSetOnce) {
  RowMarks marks(20);
  EXPECT_TRUE(rows_of(marks).empty());
  for (const std::size_t row : {19U, 0U, 7U, 8U, 7U}) marks.add(row);
  EXPECT_EQ(rows_of(marks), (std::vector<std::size_t>{0, 7, 8, 19}));
  marks.clear();
  EXPECT_TRUE(rows_of(marks).empty());
}

TEST(RowMarks, AnAdderAddsToTheSet) {
  RowMarks marks(9);
  const auto add = marks.adder();
  add(8);
  add(2);
  EXPECT_EQ(rows_of(marks), (std::vector<std::size_t>{2, 8}));
}

TEST(RowMarks, TwoSetsChangePlaces) {
  RowMarks one(9);
  RowMarks other(9);
  one.add(3);
  one.swap(other);
  EXPECT_TRUE(rows_of(one).empty());
  EXPECT_EQ(rows_of(other), (std::vector<std::size_t>{3}));
}

TEST(RowMarks, HoldAnySetOfAnySize) {
  Stream stream(1);
  for (int size = 0; size < 70; ++size) {
    RowMarks marks(static_cast<std::size_t>(size));
    std::set<std::size_t> expected;
    for (int k = 0; k < size; ++k) {
      const auto row = static_cast<std::size_t>(stream.between(0, size - 1));
      if (stream.uniform() < 0.5) continue;
      marks.add(row);
      expected.insert(row);
    }
    const std::vector<std::size_t> rows = rows_of(marks);
    EXPECT_EQ(std::set<std::size_t>(rows.begin(), rows.end()), expected) << size;
    EXPECT_EQ(rows.size(), expected.size()) << size;
  }
}

}  // namespace
}  // namespace pathrace::algorithms
