// Segments abreast: what they meet against the wall map, which goes row by row; and that only those are left
// to it which come close to a corner or a line.
#include "algorithms/pso/row_changes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>

#include "algorithms/pso/wall_map.hpp"
#include "tests/support/maps.hpp"

namespace pathrace::algorithms {
namespace {

using testing::grid_of;
using testing::random_grid;

constexpr std::size_t lanes = RowChanges::lanes;

struct Segment {
  Tick from;
  Tick to;
};
using Segments = std::array<Segment, lanes>;

RowChanges::Points points(const Segments& segments, Tick Segment::*end) {
  RowChanges::Points points;
  for (std::size_t k = 0; k < lanes; ++k) {
    points.x[k] = (segments[k].*end).x;
    points.y[k] = (segments[k].*end).y;
  }
  return points;
}

// Checks every lane, and returns how many are unsure.
int compare(const RowChanges& changes, const WallMap& walls, const Segments& segments) {
  RowChanges::Sums sums;
  sums.walls.fill(100);
  sums.cells.fill(200);
  const std::uint32_t unsure =
      changes.cross(points(segments, &Segment::from), points(segments, &Segment::to), sums);
  for (std::size_t k = 0; k < lanes; ++k) {
    const auto [from, to] = segments[k];
    const Crossing met = (unsure >> k & 1) != 0 ? Crossing{} : walls.cross(from, to);
    EXPECT_EQ((Crossing{sums.walls[k] - 100, sums.cells[k] - 200}), met)
        << from.x << ',' << from.y << " to " << to.x << ',' << to.y;
  }
  EXPECT_LT(unsure, 1U << lanes);
  return std::popcount(unsure);
}

std::int32_t coordinate(int cells, int grain, Stream& stream) {
  return ticks_per_cell + grain * stream.between(0, cells * ticks_per_cell / grain);
}

Segments random_segments(const OccupancyGrid& grid, int grain, Stream& stream) {
  Segments segments;
  for (auto& [from, to] : segments) {
    from.x = coordinate(grid.width(), grain, stream);
    from.y = coordinate(grid.height(), grain, stream);
    to.x = coordinate(grid.width(), grain, stream);
    to.y = coordinate(grid.height(), grain, stream);
  }
  return segments;
}

TEST(RowChanges, CountWhatTheWallMapCountsRowByRow) {
  for (std::uint64_t map = 0; map < 80; ++map) {
    Stream stream = Stream(51).fork(map);
    const int width = map % 8 == 0 ? 62 : stream.between(1, 62);
    const int height = map % 8 <= 1 ? 62 : stream.between(1, 62);
    const OccupancyGrid grid = random_grid(stream.fork("map"), width, height, 0.35);
    ASSERT_TRUE(RowChanges::cover(grid));
    const RowChanges changes(grid);
    const WallMap walls(grid);
    for (const int grain : {1, 3, 64, 512, 1024}) {
      for (int k = 0; k < 200; ++k) compare(changes, walls, random_segments(grid, grain, stream));
    }
  }
}

TEST(RowChanges, AreUnsureOfFewSegmentsOnly) {
  const OccupancyGrid grid = random_grid(Stream(52), 60, 60, 0.3);
  const RowChanges changes(grid);
  const WallMap walls(grid);
  Stream stream(53);
  int unsure = 0;
  for (int k = 0; k < 2000; ++k) unsure += compare(changes, walls, random_segments(grid, 1, stream));
  // Four coordinates, of which one in 1024 is on a line; and 14 changes of rows or so, each within 2^-15
  // columns of one in 2^14 times. 16000 segments: 62 + 14.
  EXPECT_GT(unsure, 40);
  EXPECT_LT(unsure, 150);
}

TEST(RowChanges, ASegmentThatPassesACornerByAHairIsCountedOnItsSideOfItOrUnsure) {
  const OccupancyGrid grid = random_grid(Stream(54), 62, 62, 0.5);
  const RowChanges changes(grid);
  const WallMap walls(grid);
  Stream stream(55);
  int unsure = 0;
  for (int k = 0; k < 20'000; ++k) {
    // Through a corner of cells, give or take a tick at either end, in whole multiples of a random step.
    const Tick corner{ticks_per_cell * stream.between(2, 62), ticks_per_cell * stream.between(2, 62)};
    const Tick step{stream.between(-40, 40), stream.between(-40, 40)};
    Segments segments;
    for (auto& [from, to] : segments) {
      const int back = stream.between(1, 24);
      const int on = stream.between(1, 24);
      const auto kept = [](std::int32_t tick) {
        return std::clamp(tick, ticks_per_cell, 63 * ticks_per_cell);
      };
      from = {kept(corner.x - back * step.x + stream.between(-1, 1)), kept(corner.y - back * step.y)};
      to = {kept(corner.x + on * step.x), kept(corner.y + on * step.y + stream.between(-1, 1))};
    }
    unsure += compare(changes, walls, segments);
  }
  EXPECT_GT(unsure, 20'000);
}

TEST(RowChanges, AreSureOfSegmentsAlongARowAndOfNearlyLevelOnes) {
  const OccupancyGrid grid = grid_of({"..#..", ".....", "#####"});
  const RowChanges changes(grid);
  const WallMap walls(grid);
  const Tick a = tick_of(Cell{0, 0});
  const Tick b = tick_of(Cell{4, 0});
  const Tick c = tick_of(Cell{4, 1});
  EXPECT_EQ(compare(changes, walls,
                    {{{a, b},
                      {b, a},
                      {b, c},
                      {c, b},
                      {a, {b.x, b.y + 1}},
                      {{b.x, 2047}, {a.x, 2049}},
                      {{a.x, 2049}, {b.x, 2047}},
                      {{2047, 3073}, {2049, 4095}}}}),
            0);
}

TEST(RowChanges, LeaveWhatHasNoLengthOrEndsOnALineToTheWallMap) {
  const OccupancyGrid grid = grid_of({"..", ".."});
  const RowChanges changes(grid);
  const WallMap walls(grid);
  const Tick a{1500, 1600};
  EXPECT_EQ(compare(changes, walls,
                    {{{a, a},
                      {a, {2048, 1700}},
                      {{2048, 1700}, a},
                      {a, {1700, 2048}},
                      {{1700, 1024}, a},
                      {{1024, 1024}, {3072, 3072}},
                      {{1100, 2048}, {2100, 2048}},
                      {{1536, 1536}, {2560, 2560}}}}),
            8);
}

}  // namespace
}  // namespace pathrace::algorithms
