// The pre-planned path, step by step and mend by mend, and the ridge of pheromone along it.
#include "algorithms/aco/tan/preplanned_path.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "algorithms/aco/tan/gaussian_field.hpp"
#include "algorithms/aco/tan/obstacles.hpp"
#include "core/stream.hpp"
#include "tests/support/maps.hpp"

namespace pathrace::algorithms {
namespace {

using Polyline = std::vector<Point>;

constexpr Point start{0, 0};
constexpr Point goal{10, 0};

TEST(PreplannedPath, WithoutObstaclesIsTheReference) {
  EXPECT_EQ(preplanned_path(start, goal, {}), (Polyline{start, goal}));
}

TEST(PreplannedPath, LeavesASetOnOneSideAlone) {
  EXPECT_EQ(preplanned_path(start, goal, {{{{4, 3}, 1}, {{5, 4}, 1}}}), (Polyline{start, goal}));
}

TEST(PreplannedPath, GoesToTheCentreOfLeastBendInASetThatLiesOnBothSides) {
  // Directions from the start: 1/4 up, 2/5 down. The other centre is used up with its set.
  EXPECT_EQ(preplanned_path(start, goal, {{{{4, 1}, 0.1}, {{5, -2}, 0.1}}}), (Polyline{start, {4, 1}, goal}));
}

TEST(PreplannedPath, TakesTheNearestSetFirst) {
  const std::vector<CircleSet> sets = {{{{7, 0.2}, 1}}, {{{3, 0.5}, 1}}};
  EXPECT_EQ(preplanned_path(start, goal, sets), (Polyline{start, {3, 0.5}, {7, 0.2}, goal}));
  EXPECT_EQ(preplanned_path(start, goal, {sets[1], sets[0]}), (Polyline{start, {3, 0.5}, {7, 0.2}, goal}));
}

TEST(PreplannedPath, MendASlopesOfVerticalLinesAreNoTrouble) {
  EXPECT_EQ(preplanned_path({0, 0}, {0, 10}, {{{{1, 4}, 0.1}, {{-2, 5}, 0.1}}}),
            (Polyline{{0, 0}, {1, 4}, {0, 10}}));
  EXPECT_EQ(preplanned_path({0, 10}, {0, 0}, {{{{1, 4}, 0.1}, {{-2, 5}, 0.1}}}),
            (Polyline{{0, 10}, {1, 4}, {0, 0}}));
}

TEST(PreplannedPath, MendBASingleCircleOnTheLineIsSeen) {
  EXPECT_EQ(preplanned_path(start, goal, {{{{5, 0.6}, 0.7}}}), (Polyline{start, {5, 0.6}, goal}));
  EXPECT_EQ(preplanned_path(start, goal, {{{{5, 0.6}, 0.5}}}), (Polyline{start, goal}));
}

TEST(PreplannedPath, MendCWhatLiesBehindStartOrGoalDoesNotCount) {
  EXPECT_EQ(preplanned_path(start, goal, {{{{-2, 0}, 1}}, {{{12, 0}, 1}}}), (Polyline{start, goal}));
  // A set on both sides, but with one side behind the start.
  EXPECT_EQ(preplanned_path(start, goal, {{{{-1, 1}, 0.1}, {{1, -1}, 0.1}}}), (Polyline{start, goal}));
}

TEST(PreplannedPath, MendDTheNearestSetIsTheOneWithTheNearestCountingCentre) {
  // The first set has a centre right behind the start, which does not count.
  const std::vector<CircleSet> sets = {{{{-0.5, 0}, 1}, {{6, 0}, 1}}, {{{4, 0}, 1}}};
  EXPECT_EQ(preplanned_path(start, goal, sets), (Polyline{start, {4, 0}, {6, 0}, goal}));
}

TEST(PreplannedPath, MendFACentreOnTheLineMeetsItHoweverSmall) {
  EXPECT_EQ(preplanned_path(start, goal, {{{{5, 0}, 0}}}), (Polyline{start, {5, 0}, goal}));
}

TEST(PreplannedPath, MendEVisitsEachSetAtMostOnceAndEndsAtTheGoal) {
  for (std::uint64_t i = 0; i < 100; ++i) {
    Stream stream = Stream(83).fork(i);
    const OccupancyGrid grid = testing::random_grid(stream.fork(0), 20, 20, 0.25);
    const std::vector<CircleSet> sets = connected_sets(cover(grid, {}, stream.fork(1)));
    const Point from{static_cast<double>(stream.between(0, 19)), static_cast<double>(stream.between(0, 19))};
    const Point to{static_cast<double>(stream.between(0, 19)), static_cast<double>(stream.between(0, 19))};
    const Polyline path = preplanned_path(from, to, sets);
    EXPECT_LE(path.size(), sets.size() + 2);
    EXPECT_EQ(path.front(), from);
    EXPECT_EQ(path.back(), to);
    for (const Point point : path) {
      EXPECT_TRUE(std::isfinite(point.x) && std::isfinite(point.y));
    }
  }
}

TEST(GaussianField, HasItsRidgeOnTheLineAndFallsOffByTheFormula) {
  const OccupancyGrid grid(12, 12);
  const std::vector<double> values = gaussian_field(grid, {{0, 5}, {11, 5}}, {8, 4, 1.5});
  EXPECT_DOUBLE_EQ(values[grid.index({6, 5})], 12);
  EXPECT_DOUBLE_EQ(values[grid.index({6, 6})], 8 + 4 * std::exp(-1 / 4.5));
  EXPECT_DOUBLE_EQ(values[grid.index({6, 2})], 8 + 4 * std::exp(-9 / 4.5));
  EXPECT_DOUBLE_EQ(values[grid.index({6, 9})], 8 + 4 * std::exp(-16 / 4.5));
  EXPECT_DOUBLE_EQ(values[grid.index({6, 10})], 8);  // 5 cells away, above 3 sigma = 4.5
}

TEST(GaussianField, MeasuresTheDistanceToTheNearestSegment) {
  const OccupancyGrid grid(12, 12);
  const std::vector<double> values = gaussian_field(grid, {{1, 1}, {9, 1}, {9, 9}}, {0, 1, 1});
  EXPECT_DOUBLE_EQ(values[grid.index({10, 0})], std::exp(-1.0));  // sqrt 2 from the corner
  EXPECT_DOUBLE_EQ(values[grid.index({8, 6})], std::exp(-0.5));   // 1 from the second segment
  EXPECT_DOUBLE_EQ(values[grid.index({0, 1})], std::exp(-0.5));   // 1 before the start
}

TEST(GaussianField, WithoutAmplitudeIsTheConstantToTheLastBit) {
  const OccupancyGrid grid = testing::random_grid(Stream(89), 15, 15, 0.3);
  for (const double value : gaussian_field(grid, {{0, 0}, {14, 14}}, {0.1, 0, 2})) EXPECT_EQ(value, 0.1);
  EXPECT_EQ(step_value(StepValue::mean, 0.1, 0.1), 0.1);
  EXPECT_EQ(step_value(StepValue::target, 0.3, 0.1), 0.1);
}

TEST(GaussianField, RaisesFreeCellsOnly) {
  const OccupancyGrid grid = testing::grid_of({".....", ".###.", "....."});
  const std::vector<double> values = gaussian_field(grid, {{0, 1}, {4, 1}}, {2, 1, 1});
  EXPECT_EQ(values[grid.index({2, 1})], 2);
  EXPECT_GT(values[grid.index({2, 0})], 2);
}

}  // namespace
}  // namespace pathrace::algorithms
