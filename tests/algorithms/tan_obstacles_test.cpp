// The environment of the pre-planned path: obstacles, their circles, and which circles belong together.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "algorithms/aco/tan/connectivity.hpp"
#include "algorithms/aco/tan/obstacles.hpp"
#include "tests/support/maps.hpp"

namespace pathrace::algorithms {
namespace {

using pathrace::testing::grid_of;
using pathrace::testing::random_grid;

double distance(Point a, Point b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

bool encloses(const Circle& circle, const std::vector<Point>& points) {
  return std::all_of(points.begin(), points.end(),
                     [&](Point p) { return distance(circle.centre, p) <= circle.radius + 1e-9; });
}

std::optional<Circle> through(Point a, Point b, Point c) {
  // The centre solves 2 (b - a) . z = |b|^2 - |a|^2 and the same for c.
  const double m00 = 2 * (b.x - a.x);
  const double m01 = 2 * (b.y - a.y);
  const double m10 = 2 * (c.x - a.x);
  const double m11 = 2 * (c.y - a.y);
  const double r0 = b.x * b.x + b.y * b.y - a.x * a.x - a.y * a.y;
  const double r1 = c.x * c.x + c.y * c.y - a.x * a.x - a.y * a.y;
  const double det = m00 * m11 - m01 * m10;
  if (std::fabs(det) < 1e-12) return std::nullopt;
  const Point centre{(r0 * m11 - r1 * m01) / det, (m00 * r1 - m10 * r0) / det};
  return Circle{centre, distance(centre, a)};
}

// The smallest of all circles through two or three points that enclose the rest.
double brute_force_radius(const std::vector<Point>& points) {
  if (points.size() == 1) return 0;
  double least = std::numeric_limits<double>::infinity();
  const auto offer = [&](const Circle& circle) {
    if (circle.radius < least && encloses(circle, points)) least = circle.radius;
  };
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = i + 1; j < points.size(); ++j) {
      offer({{(points[i].x + points[j].x) / 2, (points[i].y + points[j].y) / 2},
             distance(points[i], points[j]) / 2});
      for (std::size_t k = j + 1; k < points.size(); ++k) {
        if (const auto circle = through(points[i], points[j], points[k])) offer(*circle);
      }
    }
  }
  return least;
}

std::vector<Point> corners_of(const Obstacle& cells) {
  std::vector<Point> points;
  for (const Cell cell : cells) {
    for (const double dx : {-0.5, 0.5}) {
      for (const double dy : {-0.5, 0.5}) points.push_back({cell.x + dx, cell.y + dy});
    }
  }
  return points;
}

TEST(Obstacles, CellsThatTouchAtACornerAreOneObstacleOnlyUnderEightNeighbours) {
  const OccupancyGrid grid = grid_of({"#..", ".#.", "...", "..#"});
  EXPECT_EQ(obstacles_of(grid, Neighbours::eight), (std::vector<Obstacle>{{{0, 0}, {1, 1}}, {{2, 3}}}));
  EXPECT_EQ(obstacles_of(grid, Neighbours::four).size(), 3U);
}

TEST(Obstacles, EveryBlockedCellBelongsToExactlyOne) {
  for (std::uint64_t i = 0; i < 50; ++i) {
    const OccupancyGrid grid = random_grid(Stream(61).fork(i), 13, 9, 0.4);
    for (const Neighbours neighbours : {Neighbours::four, Neighbours::eight}) {
      std::vector<Cell> cells;
      for (const Obstacle& obstacle : obstacles_of(grid, neighbours)) {
        cells.insert(cells.end(), obstacle.begin(), obstacle.end());
      }
      std::sort(cells.begin(), cells.end());
      EXPECT_EQ(std::unique(cells.begin(), cells.end()), cells.end());
      EXPECT_EQ(static_cast<std::int64_t>(cells.size()), 13 * 9 - grid.free_cells());
    }
  }
}

TEST(ConvexHull, OfASquaresGridIsItsFourCorners) {
  std::vector<Point> points;
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 4; ++x) points.push_back({x * 0.5, y * 0.5});
  }
  EXPECT_EQ(convex_hull(points), (std::vector<Point>{{0, 0}, {1.5, 0}, {1.5, 1.5}, {0, 1.5}}));
}

TEST(EnclosingCircle, OfOneCellHasTheRadiusOfHalfItsDiagonal) {
  const Circle circle = smallest_enclosing_circle(corners_of({{3, 5}}), Stream(1));
  EXPECT_DOUBLE_EQ(circle.centre.x, 3);
  EXPECT_DOUBLE_EQ(circle.centre.y, 5);
  EXPECT_DOUBLE_EQ(circle.radius, std::sqrt(0.5));
}

TEST(EnclosingCircle, OfOnePointIsThePoint) {
  EXPECT_EQ(smallest_enclosing_circle({{2, 7}, {2, 7}}, Stream(1)), (Circle{{2, 7}, 0}));
}

TEST(EnclosingCircle, HoldsEveryPointAndIsTheSmallestOfAllThroughTwoOrThree) {
  for (std::uint64_t i = 0; i < 400; ++i) {
    Stream stream = Stream(67).fork(i);
    std::vector<Point> points;
    const int count = stream.between(1, 9);
    for (int k = 0; k < count; ++k)
      points.push_back({stream.between(0, 12) * 0.5, stream.between(0, 12) * 0.5});
    const Circle circle = smallest_enclosing_circle(points, stream.fork(0));
    EXPECT_TRUE(encloses(circle, points)) << i;
    std::sort(points.begin(), points.end(),
              [](Point a, Point b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
    points.erase(std::unique(points.begin(), points.end()), points.end());
    EXPECT_NEAR(circle.radius, brute_force_radius(points), 1e-9) << i;
  }
}

TEST(Cover, ACompactObstacleHasOneCircleAndALongOneSeveral) {
  // One cell: pi / 2 of its area; two in a row: 1.25 pi / 2 = 1.96. Three: 2.5 pi / 3 = 2.62, halved.
  const Stream order(1);
  EXPECT_EQ(cover(Obstacle{{0, 0}}, {}, order).size(), 1U);
  EXPECT_EQ(cover(Obstacle{{0, 0}, {1, 0}}, {}, order).size(), 1U);
  const std::vector<Circle> circles = cover(Obstacle{{0, 0}, {1, 0}, {2, 0}}, {}, order);
  ASSERT_EQ(circles.size(), 2U);
  EXPECT_DOUBLE_EQ(circles[0].centre.x, 0);
  EXPECT_DOUBLE_EQ(circles[1].centre.x, 1.5);
}

TEST(Cover, HoldsEveryCornerOfEveryBlockedCellWhateverTheSettings) {
  for (std::uint64_t i = 0; i < 60; ++i) {
    const OccupancyGrid grid = random_grid(Stream(71).fork(i), 16, 11, 0.1 + 0.01 * static_cast<double>(i));
    for (const CoverSettings& settings :
         {CoverSettings{}, CoverSettings{Neighbours::four, 3, 2}, CoverSettings{Neighbours::eight, 1e9, 6}}) {
      const std::vector<Circle> circles = cover(grid, settings, Stream(2));
      for (int y = 0; y < grid.height(); ++y) {
        for (int x = 0; x < grid.width(); ++x) {
          if (grid.is_free({x, y})) continue;
          const std::vector<Point> corners = corners_of({{x, y}});
          EXPECT_TRUE(std::any_of(circles.begin(), circles.end(),
                                  [&](const Circle& circle) { return encloses(circle, corners); }))
              << i << ": " << x << ',' << y;
        }
      }
    }
  }
}

TEST(Cover, WithoutSplittingThereIsOneCirclePerObstacle) {
  const OccupancyGrid grid = random_grid(Stream(73), 20, 20, 0.3);
  EXPECT_EQ(cover(grid, {Neighbours::eight, 1e9, 6}, Stream(1)).size(),
            obstacles_of(grid, Neighbours::eight).size());
  EXPECT_EQ(cover(grid, {Neighbours::eight, 0, 0}, Stream(1)).size(),
            obstacles_of(grid, Neighbours::eight).size());
}

TEST(Connectivity, IsEquationFourWithTouchingCirclesConnected) {
  const Circle unit{{0, 0}, 1};
  EXPECT_TRUE(connected(unit, {{1.9, 0}, 1}));
  EXPECT_TRUE(connected(unit, {{2, 0}, 1}));
  EXPECT_FALSE(connected(unit, {{2.001, 0}, 1}));
  EXPECT_TRUE(connected(unit, {{0.1, 0.1}, 0.2}));
}

TEST(Connectivity, AChainIsOneSetAndALonelyCircleASetOfItsOwn) {
  const std::vector<Circle> circles = {{{0, 0}, 1}, {{9, 9}, 1}, {{3.5, 0}, 1}, {{1.7, 0}, 1}};
  const std::vector<CircleSet> sets = connected_sets(circles);
  ASSERT_EQ(sets.size(), 2U);
  EXPECT_EQ(sets[0], (CircleSet{circles[0], circles[2], circles[3]}));
  EXPECT_EQ(sets[1], CircleSet{circles[1]});
}

TEST(Connectivity, AgreesWithTheWholeMatrix) {
  for (std::uint64_t i = 0; i < 60; ++i) {
    Stream stream = Stream(79).fork(i);
    std::vector<Circle> circles;
    for (int k = 0; k < 25; ++k) {
      circles.push_back({{stream.uniform() * 20, stream.uniform() * 20}, 0.3 + 1.5 * stream.uniform()});
    }
    // The representative of each circle by flooding the matrix A.
    std::vector<std::size_t> set(circles.size());
    for (std::size_t a = 0; a < set.size(); ++a) set[a] = a;
    for (bool changed = true; changed;) {
      changed = false;
      for (std::size_t a = 0; a < set.size(); ++a) {
        for (std::size_t b = 0; b < set.size(); ++b) {
          if (connected(circles[a], circles[b]) && set[b] > set[a]) {
            set[b] = set[a];
            changed = true;
          }
        }
      }
    }
    std::vector<CircleSet> expected(circles.size());
    for (std::size_t a = 0; a < set.size(); ++a) expected[set[a]].push_back(circles[a]);
    expected.erase(std::remove(expected.begin(), expected.end(), CircleSet{}), expected.end());
    EXPECT_EQ(connected_sets(circles), expected) << i;
  }
}

}  // namespace
}  // namespace pathrace::algorithms
