#include "core/grid.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "core/error.hpp"

namespace pathrace {
namespace {

std::string refusal(int width, int height) {
  try {
    OccupancyGrid grid(width, height);
  } catch (const InvalidScenario& error) {
    return error.what();
  }
  return "accepted";
}

TEST(OccupancyGrid, StartsFree) {
  const OccupancyGrid grid(3, 2);
  EXPECT_EQ(grid.width(), 3);
  EXPECT_EQ(grid.height(), 2);
  EXPECT_EQ(grid.free_cells(), 6);
  for (int y = 0; y < 2; ++y) {
    for (int x = 0; x < 3; ++x) EXPECT_TRUE(grid.is_free({x, y}));
  }
}

TEST(OccupancyGrid, ACellIsBlockedAloneAndClearedAgain) {
  OccupancyGrid grid(3, 2);
  grid.block({2, 1});
  EXPECT_EQ(grid.free_cells(), 5);
  EXPECT_FALSE(grid.is_free({2, 1}));
  EXPECT_TRUE(grid.is_free({1, 1}));
  grid.clear({2, 1});
  EXPECT_EQ(grid, OccupancyGrid(3, 2));
}

TEST(OccupancyGrid, NoCellOutsideTheMapIsFree) {
  const OccupancyGrid grid(3, 2);
  for (const Cell cell : {Cell{-1, 0}, Cell{0, -1}, Cell{3, 0}, Cell{0, 2}, Cell{-1, -1}, Cell{3, 2},
                          Cell{1000000, 0}, Cell{0, -1000000}}) {
    EXPECT_FALSE(grid.contains(cell)) << cell.x << "," << cell.y;
    EXPECT_FALSE(grid.is_free(cell)) << cell.x << "," << cell.y;
  }
}

TEST(OccupancyGrid, AFrameOfBlockedCellsSurroundsTheMap) {
  const OccupancyGrid grid(3, 2);
  EXPECT_EQ(grid.stride(), 5U);
  EXPECT_EQ(grid.padded_size(), 20U);
  for (int y = -1; y <= 2; ++y) {
    for (int x = -1; x <= 3; ++x) EXPECT_EQ(grid.blocked_at(grid.index({x, y})), !grid.contains({x, y}));
  }
}

TEST(OccupancyGrid, IndexAndCellAreInverse) {
  const OccupancyGrid grid(4, 3);
  EXPECT_EQ(grid.index({0, 0}), 7U);  // one row of 6 and one cell of frame before it
  for (std::size_t i = 0; i < grid.padded_size(); ++i) EXPECT_EQ(grid.index(grid.cell(i)), i);
}

TEST(OccupancyGrid, RefusesAMapWithoutCellsAndNamesItsSize) {
  EXPECT_EQ(refusal(0, 7), "grid must be at least 1x1 cells, got 0x7");
  EXPECT_EQ(refusal(7, 0), "grid must be at least 1x1 cells, got 7x0");
  EXPECT_EQ(refusal(-3, 5), "grid must be at least 1x1 cells, got -3x5");
  EXPECT_EQ(refusal(1, 1), "accepted");
}

TEST(OccupancyGrid, RefusesAMapThatIsTooLargeAndNamesItsSize) {
  EXPECT_EQ(refusal(16385, 1), "grid must have at most 16384 cells a side and 134217728 in all, got 16385x1");
  EXPECT_EQ(refusal(1, 16385), "grid must have at most 16384 cells a side and 134217728 in all, got 1x16385");
  EXPECT_EQ(refusal(8193, 16384),
            "grid must have at most 16384 cells a side and 134217728 in all, got 8193x16384");
  EXPECT_EQ(refusal(2147483647, 2147483647),
            "grid must have at most 16384 cells a side and 134217728 in all, got 2147483647x2147483647");
  EXPECT_EQ(refusal(16384, 1024), "accepted");
}

TEST(OccupancyGrid, RefusesToBlockOrClearACellOutside) {
  OccupancyGrid grid(3, 2);
  for (const auto act : {&OccupancyGrid::block, &OccupancyGrid::clear}) {
    try {
      (grid.*act)({3, 0});
      ADD_FAILURE() << "accepted";
    } catch (const InvalidScenario& error) {
      EXPECT_STREQ(error.what(), "cell 3,0 is outside the 3x2 grid");
    }
  }
  EXPECT_EQ(grid, OccupancyGrid(3, 2));
}

TEST(OccupancyGrid, EqualMapsAreEqualAndShapesMatter) {
  EXPECT_EQ(OccupancyGrid(2, 3), OccupancyGrid(2, 3));
  EXPECT_NE(OccupancyGrid(2, 3), OccupancyGrid(3, 2));
  OccupancyGrid blocked(2, 3);
  blocked.block({1, 1});
  EXPECT_NE(blocked, OccupancyGrid(2, 3));
}

}  // namespace
}  // namespace pathrace
