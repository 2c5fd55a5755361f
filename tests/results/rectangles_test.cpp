#include "results/rectangles.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "tests/support/maps.hpp"

namespace pathrace::results {
namespace {

using pathrace::testing::grid_of;
using pathrace::testing::random_grid;

TEST(Rectangles, MakeOneOfAWall) {
  EXPECT_EQ(blocked_rectangles(grid_of({"....", ".##.", ".##.", ".##."})),
            (std::vector<Rectangle>{{1, 1, 2, 3}}));
  EXPECT_EQ(blocked_rectangles(grid_of({"###", "###"})), (std::vector<Rectangle>{{0, 0, 3, 2}}));
}

TEST(Rectangles, OfAFreeMapAreNone) {
  EXPECT_TRUE(blocked_rectangles(grid_of({"...", "..."})).empty());
}

TEST(Rectangles, OfTheLetterLAreTwo) {
  EXPECT_EQ(blocked_rectangles(grid_of({"#..", "#..", "###"})),
            (std::vector<Rectangle>{{0, 0, 1, 2}, {0, 2, 3, 1}}));
}

TEST(Rectangles, CoverEachBlockedCellOnceAndNoFreeOne) {
  const Stream stream(7);
  for (std::uint64_t i = 0; i < 60; ++i) {
    const OccupancyGrid grid = random_grid(stream.fork(i), 1 + static_cast<int>(i % 13),
                                           1 + static_cast<int>(i % 7), static_cast<double>(i % 10) / 10);
    std::vector<int> covered(grid.padded_size(), 0);
    for (const Rectangle& r : blocked_rectangles(grid)) {
      for (int y = r.y; y < r.y + r.height; ++y) {
        for (int x = r.x; x < r.x + r.width; ++x) {
          ASSERT_TRUE(grid.contains({x, y}));
          ++covered[grid.index({x, y})];
        }
      }
    }
    for (int y = 0; y < grid.height(); ++y) {
      for (int x = 0; x < grid.width(); ++x) {
        EXPECT_EQ(covered[grid.index({x, y})], grid.is_free({x, y}) ? 0 : 1)
            << "map " << i << " at " << x << "," << y;
      }
    }
  }
}

}  // namespace
}  // namespace pathrace::results
