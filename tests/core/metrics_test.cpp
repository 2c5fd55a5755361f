// Metrics of paths measured by hand. The clearance of a cell on a map without obstacles is its distance to
// the nearest cell outside, so the cells of a 5x5 map have clearances 1 1 1 1 1 / 1 2 2 2 1 / 1 2 3 2 1 / ...

#include "core/metrics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "tests/support/maps.hpp"

namespace pathrace {
namespace {

constexpr double pi = std::numbers::pi;

PathMetrics measured(const OccupancyGrid& grid, const std::vector<Cell>& cells) {
  return measure(lattice_path(cells), DistanceTransform(grid));
}

PathMetrics measured_any_angle(const OccupancyGrid& grid, std::vector<Point> points) {
  return measure(Path{Track::any_angle, std::move(points)}, DistanceTransform(grid));
}

TEST(LatticeMetrics, CountStepsTurnsAnglesAndClearance) {
  // East, south-east, south, west: turns of 45, 45 and 90 degrees. Clearances 1, 1, 2, 3, 2.
  const PathMetrics metrics = measured(OccupancyGrid(5, 5), {{0, 0}, {1, 0}, {2, 1}, {2, 2}, {1, 2}});
  ASSERT_TRUE(metrics.lattice);
  EXPECT_EQ(*metrics.lattice, (LatticeLength{3, 1}));
  EXPECT_NEAR(metrics.length, 4.414213562373095, 1e-14);
  EXPECT_EQ(metrics.turns, 3);
  EXPECT_DOUBLE_EQ(metrics.turn_angle, pi);
  EXPECT_EQ(metrics.clearance_min, 1.0);
  EXPECT_DOUBLE_EQ(metrics.clearance_mean, 1.8);
}

TEST(LatticeMetrics, AStraightLineHasNoTurns) {
  const PathMetrics metrics = measured(OccupancyGrid(5, 5), {{0, 0}, {1, 1}, {2, 2}, {3, 3}, {4, 4}});
  EXPECT_EQ(*metrics.lattice, (LatticeLength{0, 4}));
  EXPECT_EQ(metrics.turns, 0);
  EXPECT_EQ(metrics.turn_angle, 0.0);
}

TEST(LatticeMetrics, TurningBackIsOneTurnOfHalfACircle) {
  const PathMetrics metrics = measured(OccupancyGrid(3, 1), {{0, 0}, {1, 0}, {0, 0}});
  EXPECT_EQ(*metrics.lattice, (LatticeLength{2, 0}));
  EXPECT_EQ(metrics.turns, 1);
  EXPECT_DOUBLE_EQ(metrics.turn_angle, pi);
}

// From each of the eight headings to each other: the angle is the difference of their numbers in eighths.
TEST(LatticeMetrics, EveryPairOfHeadingsTurnsByTheAngleBetweenThem) {
  const Cell headings[] = {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}};
  for (int a = 0; a < 8; ++a) {
    for (int b = 0; b < 8; ++b) {
      const Cell first = headings[a];
      const Cell second = headings[b];
      const Cell middle{2 + first.x, 2 + first.y};
      const PathMetrics metrics =
          measured(OccupancyGrid(5, 5), {{2, 2}, middle, {middle.x + second.x, middle.y + second.y}});
      const double cosine = (first.x * second.x + first.y * second.y) /
                            (std::hypot(first.x, first.y) * std::hypot(second.x, second.y));
      EXPECT_NEAR(metrics.turn_angle, std::acos(std::fmax(-1.0, std::fmin(1.0, cosine))), 1e-7);
      EXPECT_EQ(metrics.turns, a == b ? 0 : 1);
    }
  }
}

TEST(LatticeMetrics, APathOfOnePointHasLengthZeroAndThatCellsClearance) {
  const PathMetrics metrics = measured(OccupancyGrid(5, 5), {{2, 2}});
  EXPECT_EQ(*metrics.lattice, (LatticeLength{0, 0}));
  EXPECT_EQ(metrics.length, 0.0);
  EXPECT_EQ(metrics.turns, 0);
  EXPECT_EQ(metrics.clearance_min, 3.0);
  EXPECT_EQ(metrics.clearance_mean, 3.0);
}

TEST(LatticeMetrics, ClearanceIsTheDistanceToTheNearestObstacle) {
  OccupancyGrid grid(9, 9);
  grid.block({4, 2});
  // At 3,4 and 5,4 the obstacle is a knight's move away, at 4,4 two cells.
  const PathMetrics metrics = measured(grid, {{3, 4}, {4, 4}, {5, 4}});
  EXPECT_EQ(metrics.clearance_min, 2.0);
  EXPECT_NEAR(metrics.clearance_mean, (2 + 2 * std::sqrt(5.0)) / 3, 1e-14);
}

TEST(AnyAngleMetrics, MeasureLengthAndTheAngleOfATurn) {
  // 5 along (3, 4), then 4 along (0, 1): the cosine between them is 4/5.
  const PathMetrics metrics = measured_any_angle(OccupancyGrid(12, 12), {{1, 1}, {4, 5}, {4, 9}});
  EXPECT_FALSE(metrics.lattice);
  EXPECT_DOUBLE_EQ(metrics.length, 9.0);
  EXPECT_EQ(metrics.turns, 1);
  EXPECT_NEAR(metrics.turn_angle, 0.6435011087932844, 1e-14);
}

TEST(AnyAngleMetrics, PointsOnALineAndRepeatedPointsAreNoTurns) {
  const PathMetrics metrics =
      measured_any_angle(OccupancyGrid(12, 12), {{0, 0}, {3, 1}, {3, 1}, {9, 3}, {9, 3}});
  EXPECT_EQ(metrics.turns, 0);
  EXPECT_EQ(metrics.turn_angle, 0.0);
  EXPECT_NEAR(metrics.length, 3 * std::sqrt(10.0), 1e-14);
}

TEST(AnyAngleMetrics, TurningBackIsOneTurnOfHalfACircle) {
  const PathMetrics metrics = measured_any_angle(OccupancyGrid(12, 12), {{0, 0}, {6, 2}, {3, 1}});
  EXPECT_EQ(metrics.turns, 1);
  EXPECT_DOUBLE_EQ(metrics.turn_angle, pi);
}

// One long segment visits the same cells as the steps along it, wherever the obstacle stands.
TEST(AnyAngleMetrics, ALongSegmentHasTheClearanceOfTheStepsAlongIt) {
  for (int x = 0; x < 9; ++x) {
    OccupancyGrid grid(9, 9);
    grid.block({x, 3});
    const PathMetrics steps =
        measured(grid, {{0, 4}, {1, 4}, {2, 4}, {3, 4}, {4, 4}, {5, 4}, {6, 4}, {7, 4}, {8, 4}});
    const PathMetrics segment = measured_any_angle(grid, {{0, 4}, {8, 4}});
    EXPECT_EQ(segment.clearance_min, steps.clearance_min) << x;
    EXPECT_EQ(segment.clearance_mean, steps.clearance_mean) << x;
    OccupancyGrid other(9, 9);
    other.block({x, x == 8 ? 7 : x + 1});
    const PathMetrics diagonal_steps =
        measured(other, {{0, 0}, {1, 1}, {2, 2}, {3, 3}, {4, 4}, {5, 5}, {6, 6}, {7, 7}, {8, 8}});
    const PathMetrics diagonal_segment = measured_any_angle(other, {{0, 0}, {8, 8}});
    EXPECT_EQ(diagonal_segment.clearance_min, diagonal_steps.clearance_min) << x;
    EXPECT_EQ(diagonal_segment.clearance_mean, diagonal_steps.clearance_mean) << x;
  }
}

// A path may run along the edge of the map, half a cell beyond the last centres.
TEST(AnyAngleMetrics, APathAlongTheEdgeOfTheMapHasTheClearanceOfTheCellsBesideIt) {
  const OccupancyGrid grid(4, 3);
  for (const double y : {-0.5, 2.5}) {
    const PathMetrics metrics = measured_any_angle(grid, {{-0.5, y}, {3.5, y}});
    EXPECT_EQ(metrics.length, 4.0);
    EXPECT_EQ(metrics.clearance_min, 1.0);
    EXPECT_EQ(metrics.clearance_mean, 1.0);
  }
}

}  // namespace
}  // namespace pathrace
