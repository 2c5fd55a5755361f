#include "core/distance_transform.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <limits>

#include "tests/support/maps.hpp"

namespace pathrace {
namespace {

// Looks at every cell within reach: the nearest cell outside the map is never beyond the frame.
std::int64_t nearest_blocked(const OccupancyGrid& grid, Cell from) {
  std::int64_t least = std::numeric_limits<std::int64_t>::max();
  for (int y = -1; y <= grid.height(); ++y) {
    for (int x = -1; x <= grid.width(); ++x) {
      if (grid.is_free({x, y})) continue;
      const std::int64_t dx = x - from.x;
      const std::int64_t dy = y - from.y;
      least = std::min(least, dx * dx + dy * dy);
    }
  }
  return least;
}

void expect_exact(const OccupancyGrid& grid) {
  const DistanceTransform transform(grid);
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x) {
      ASSERT_EQ(transform.squared({x, y}), nearest_blocked(grid, {x, y})) << x << "," << y;
    }
  }
}

TEST(DistanceTransform, EqualsBruteForceOnRandomMapsOfAnyDensity) {
  const Stream seeds(1);
  for (std::uint64_t i = 0; i < 300; ++i) {
    Stream stream = seeds.fork(i);
    const int width = stream.between(1, 24);
    const int height = stream.between(1, 24);
    expect_exact(testing::random_grid(stream.fork(0), width, height, stream.uniform()));
    if (HasFatalFailure()) FAIL() << "map " << i;
  }
}

TEST(DistanceTransform, EqualsBruteForceOnSparseMapsWhereDistancesAreLong) {
  const Stream seeds(2);
  for (std::uint64_t i = 0; i < 20; ++i) {
    expect_exact(testing::random_grid(seeds.fork(i), 60, 60, 0.002));
    if (HasFatalFailure()) FAIL() << "map " << i;
  }
}

TEST(DistanceTransform, WithAnOpenBorderOnlyBlockedCellsOfTheMapCount) {
  const Stream seeds(3);
  for (std::uint64_t i = 0; i < 100; ++i) {
    Stream stream = seeds.fork(i);
    const int width = stream.between(1, 24);
    const OccupancyGrid grid = testing::random_grid(stream.fork(0), width, stream.between(1, 24), 0.03);
    const DistanceTransform transform(grid, Border::open);
    for (int y = 0; y < grid.height(); ++y) {
      for (int x = 0; x < grid.width(); ++x) {
        std::int64_t least = DistanceTransform::far;
        for (int v = 0; v < grid.height(); ++v) {
          for (int u = 0; u < grid.width(); ++u) {
            if (grid.is_free({u, v})) continue;
            least = std::min(least, std::int64_t{(x - u) * (x - u) + (y - v) * (y - v)});
          }
        }
        ASSERT_EQ(std::min(transform.squared({x, y}), DistanceTransform::far), least) << "map " << i;
      }
    }
  }
}

TEST(DistanceTransform, OutsideTheMapIsBlocked) {
  const DistanceTransform transform(OccupancyGrid(5, 5));
  EXPECT_EQ(transform.squared({0, 0}), 1);
  EXPECT_EQ(transform.squared({2, 2}), 9);
  EXPECT_EQ(transform.squared({4, 2}), 1);
}

TEST(DistanceTransform, ABlockedCellHasDistanceZeroAndAKnightsMoveIsRootFive) {
  OccupancyGrid grid(9, 9);
  grid.block({4, 4});
  const DistanceTransform transform(grid);
  EXPECT_EQ(transform.distance({4, 4}), 0.0);
  EXPECT_EQ(transform.distance({4, 3}), 1.0);
  EXPECT_NEAR(transform.distance({3, 2}), 2.23606797749979, 1e-14);
}

}  // namespace
}  // namespace pathrace
