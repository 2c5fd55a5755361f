// Numbers of shortest paths, against enumeration, published counts and binomial coefficients.
#include "bench/features/path_count.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <optional>
#include <vector>

#include "tests/support/maps.hpp"
#include "tests/support/oracle.hpp"

namespace pathrace::bench {
namespace {

using testing::Question;

PathCount count(const OccupancyGrid& grid, MoveRule rule, Cell start, Cell goal) {
  const Terrain terrain = testing::terrain_of(grid, rule);
  return count_shortest_paths(reference::DistanceField(terrain, start, goal), *terrain.grid, goal);
}

// Every way of at most a given length, step by step.
class Enumeration {
 public:
  Enumeration(const Question& question, MoveRule rule, LatticeLength longest)
      : question_(question), rule_(rule), longest_(longest) {}

  int from(Cell cell, LatticeLength length) const {
    // A step leads to the next column or row at most, and is no shorter than 1.
    const int columns = std::abs(question_.goal.x - cell.x);
    const int rows = std::abs(question_.goal.y - cell.y);
    const std::int64_t straight = length.straight + std::max(columns, rows);
    if (testing::sign_of(straight - longest_.straight, length.diagonal - longest_.diagonal) > 0) return 0;
    int ways = cell == question_.goal ? 1 : 0;
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const Cell next{cell.x + dx, cell.y + dy};
        if (next == cell || !testing::oracle_step(question_.grid, rule_, cell, next)) continue;
        const bool diagonal = dx != 0 && dy != 0;
        ways += from(next, length + LatticeLength{diagonal ? 0 : 1, diagonal ? 1 : 0});
      }
    }
    return ways;
  }

 private:
  const Question& question_;
  MoveRule rule_;
  LatticeLength longest_;
};

TEST(PathCount, IsTheNumberThatEnumerationFindsOnSmallMaps) {
  int counted = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    const Question question = testing::random_question(Stream(seed), 5, 0.5);
    for (const MoveRule rule : testing::all_rules) {
      const auto optimum = testing::oracle_optimum(question.grid, rule, question.start, question.goal);
      if (!optimum || optimum->value() > 7) continue;  // longer ones take for ever
      const int ways = Enumeration(question, rule, *optimum).from(question.start, {});
      const PathCount found = count(question.grid, rule, question.start, question.goal);
      EXPECT_EQ(found.mantissa, ways) << name(rule);
      EXPECT_EQ(found.exponent, 0);
      ++counted;
    }
  }
  EXPECT_GT(counted, 500);
}

TEST(PathCount, IsThePublishedNumberOnTheReferenceMaps) {
  const std::map<std::string, std::pair<double, double>> free_and_strict = {
      {"asr/fig2", {1, 4}},
      {"asr/fig5", {1, 2}},
      {"asr/fig6", {1, 4}},
      {"curated/trap-l-20", {2004002, 3726450}},
      {"curated/trap-u-east-20", {4, 50}},
      {"curated/trap-hook-20", {414050, 627200}},
      {"curated/trap-nested-l-20", {28800, 36992}},
      {"curated/trap-baffle-20", {107057160000, 314049650688}},
      {"curated/trap-comb-20", {340704, 563108}},
      {"curated/trap-tunnel-20", {360360, 400400}},
      {"curated/trap-spiral-20", {72, 252}},
      {"curated/trap-pocket-10", {99, 120}},
  };
  ASSERT_EQ(testing::reference_maps().size(), free_and_strict.size());
  for (const testing::ReferenceMap& map : testing::reference_maps()) {
    const OccupancyGrid grid = testing::grid_of(map.rows);
    const auto& [free, strict] = free_and_strict.at(map.name);
    EXPECT_EQ(count(grid, MoveRule::free, map.start, map.goal).mantissa, free) << map.name;
    EXPECT_EQ(count(grid, MoveRule::strict, map.start, map.goal).mantissa, strict) << map.name;
  }
}

// m columns and k rows further on an empty map, a shortest path makes m steps, k of them diagonal: C(m, k).
TEST(PathCount, IsABinomialCoefficientOnAnEmptyMap) {
  const OccupancyGrid grid(101, 51);
  EXPECT_EQ(count(grid, MoveRule::strict, {0, 0}, {100, 2}).mantissa, 100 * 99 / 2);
  const double c_100_50 = 100891344545564193334812497256.0;
  const PathCount found = count(grid, MoveRule::free, {0, 0}, {100, 50});
  EXPECT_NEAR(found.mantissa / c_100_50, 1, 1e-14);
  EXPECT_NEAR(found.log10(), std::log10(c_100_50), 1e-13);
}

TEST(PathCount, GoesOnWhereDoublesEnd) {
  PathCount count{1, 0};
  for (int i = 0; i < 5000; ++i) count.add(count);  // 2^5000, fifteen hundred digits
  EXPECT_EQ(count.exponent, 9);                     // 5000 = 9 * 512 + 392
  EXPECT_EQ(count.mantissa, 0x1p392);
  EXPECT_NEAR(count.log10(), 5000 * 0.30102999566398119521, 1e-12);
}

TEST(PathCount, AddsCountsOfDifferentSizeInEitherOrder) {
  const PathCount large{1, 1};  // 2^512
  const PathCount near{0x1p500, 0};
  PathCount one = large;
  one.add(near);
  PathCount other = near;
  other.add(large);
  EXPECT_EQ(one.mantissa, 1 + 0x1p-12);
  EXPECT_EQ(one.exponent, 1);
  EXPECT_EQ(other.mantissa, one.mantissa);
  EXPECT_EQ(other.exponent, one.exponent);
  one.add({1, 5});  // so much larger that what was there is below its last place
  EXPECT_EQ(one.mantissa, 1);
  EXPECT_EQ(one.exponent, 5);
  one.add({});
  EXPECT_EQ(one.mantissa, 1);
}

TEST(PathCount, HasTheLogarithmOfTheLibraryToTheLastPlaces) {
  EXPECT_EQ((PathCount{1, 0}.log10()), 0);
  for (double count = 2; count < 1e100; count *= 3.7) {
    EXPECT_NEAR((PathCount{count, 0}.log10()), std::log10(count),
                1e-15 * std::max(1.0, std::log10(count)) * 4)
        << count;
  }
}

}  // namespace
}  // namespace pathrace::bench
