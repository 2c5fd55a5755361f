// Where start and goal lie, on maps drawn by hand.
#include "scenarios/ends.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "scenarios/components.hpp"
#include "tests/support/maps.hpp"
#include "tests/support/oracle.hpp"

namespace pathrace::scenarios {
namespace {

using pathrace::testing::free_cells_of;
using pathrace::testing::grid_of;
using pathrace::testing::oracle_optimum;

Sketch sketch_of(const OccupancyGrid& grid) {
  return {grid, {}, {}};
}

TEST(LargestRegion, HasTheMostCellsSideBySide) {
  const OccupancyGrid grid = grid_of({"..#..", "..#..", "##...", "..#.."});
  const std::vector<Cell> cells = largest_region(grid);
  EXPECT_EQ(cells.size(), 9U);  // the right half, 2 + 2 + 3 + 2
  for (const Cell cell : cells) EXPECT_GE(cell.x, 2);
  EXPECT_TRUE(largest_region(grid_of({"##", "##"})).empty());
}

TEST(LargestRegion, IsTheFirstRowByRowOfEquals) {
  EXPECT_EQ(largest_region(grid_of({".#."})), std::vector<Cell>{(Cell{0, 0})});
}

TEST(LargestRegion, DoesNotLeadThroughTouchingCorners) {
  EXPECT_EQ(largest_region(grid_of({".#", "#."})).size(), 1U);
}

TEST(Ends, CornersAreTheNearestCellsOfTheRegion) {
  Sketch sketch = sketch_of(grid_of({"#...", "....", "...#", "..##"}));
  Stream stream(1);
  ASSERT_TRUE(place_ends(sketch, Ends::corners, 50, stream));
  EXPECT_EQ(sketch.start, (Cell{1, 0}));  // as near as (0,1), and before it row by row
  EXPECT_EQ(sketch.goal, (Cell{2, 2}));
}

TEST(Ends, FarFindsTheTwoEndsOfACorridor) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Sketch sketch = sketch_of(grid_of({".....", "####.", "....."}));
    Stream stream(seed);
    ASSERT_TRUE(place_ends(sketch, Ends::far, 50, stream));
    EXPECT_EQ(std::min(sketch.start, sketch.goal), (Cell{0, 0}));
    EXPECT_EQ(std::max(sketch.start, sketch.goal), (Cell{0, 2}));
  }
}

TEST(Ends, FarCellsAreEachFarthestFromTheOther) {
  for (std::uint64_t i = 0; i < 30; ++i) {
    Sketch sketch = sketch_of(testing::random_grid(Stream(51).fork(i), 9, 9, 0.35));
    Stream stream = Stream(52).fork(i);
    ASSERT_TRUE(place_ends(sketch, Ends::far, 50, stream));
    const auto between = oracle_optimum(sketch.grid, MoveRule::strict, sketch.start, sketch.goal);
    for (const Cell cell : free_cells_of(sketch.grid)) {
      for (const Cell end : {sketch.start, sketch.goal}) {
        const auto other = oracle_optimum(sketch.grid, MoveRule::strict, end, cell);
        EXPECT_FALSE(other && *other > *between) << i;
      }
    }
  }
}

TEST(Ends, RandomGoalsLieAtTheAskedShareOfTheGreatestDistance) {
  for (const int difficulty : {20, 50, 80, 100}) {
    for (std::uint64_t i = 0; i < 10; ++i) {
      Sketch sketch = sketch_of(OccupancyGrid(30, 30));
      Stream stream = Stream(53).fork(i);
      ASSERT_TRUE(place_ends(sketch, Ends::random, difficulty, stream));
      double greatest = 0;  // on open ground the farthest cell is a corner
      for (const Cell corner : {Cell{0, 0}, Cell{29, 0}, Cell{0, 29}, Cell{29, 29}}) {
        const int dx = std::abs(corner.x - sketch.start.x);
        const int dy = std::abs(corner.y - sketch.start.y);
        const LatticeLength length{std::abs(dx - dy), std::min(dx, dy)};
        greatest = std::max(greatest, length.value());
      }
      const auto length = oracle_optimum(sketch.grid, MoveRule::strict, sketch.start, sketch.goal);
      EXPECT_NEAR(length->value() / greatest, difficulty / 100.0, 0.0500001);
    }
  }
}

TEST(Ends, AMapWithoutTwoNeighbouringCellsHasNone) {
  Sketch sketch = sketch_of(grid_of({".#", "#."}));
  Stream stream(1);
  for (const Ends rule : {Ends::corners, Ends::far, Ends::random}) {
    EXPECT_FALSE(place_ends(sketch, rule, 50, stream));
  }
}

}  // namespace
}  // namespace pathrace::scenarios
