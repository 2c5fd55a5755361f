// The wall map: its counts against an oracle that asks each cell of the map, in whole numbers, and its
// verdicts against the referee's.
#include "algorithms/pso/wall_map.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "core/referee.hpp"
#include "tests/support/maps.hpp"

namespace pathrace::algorithms {
namespace {

using testing::grid_of;
using testing::random_grid;
using testing::terrain_of;

constexpr std::int64_t side = ticks_per_cell;

std::int64_t turn(Tick p, Tick q, std::int64_t x, std::int64_t y) {
  return (std::int64_t{q.x} - p.x) * (y - p.y) - (std::int64_t{q.y} - p.y) * (x - p.x);
}

bool enters(Tick p, Tick q, std::int64_t left, std::int64_t top) {
  const std::int64_t right = left + side;
  const std::int64_t bottom = top + side;
  if (std::max(p.x, q.x) <= left || std::min(p.x, q.x) >= right) return false;
  if (std::max(p.y, q.y) <= top || std::min(p.y, q.y) >= bottom) return false;
  const auto [least, most] = std::minmax(
      {turn(p, q, left, top), turn(p, q, right, top), turn(p, q, left, bottom), turn(p, q, right, bottom)});
  return least < 0 && most > 0;
}

bool touches(Tick p, Tick q, std::int64_t x, std::int64_t y) {
  return turn(p, q, x, y) == 0 && x >= std::min(p.x, q.x) && x <= std::max(p.x, q.x) &&
         y >= std::min(p.y, q.y) && y <= std::max(p.y, q.y);
}

// Blocked cells entered, closed corners touched, edges between two blocked cells run along.
std::uint32_t oracle_walls(const OccupancyGrid& grid, Tick p, Tick q) {
  std::uint32_t walls = 0;
  for (int y = -1; y <= grid.height(); ++y) {
    for (int x = -1; x <= grid.width(); ++x) {
      const std::int64_t left = side * (x + 1);
      const std::int64_t top = side * (y + 1);
      const bool blocked = !grid.is_free({x, y});
      const bool west = !grid.is_free({x - 1, y});
      const bool north = !grid.is_free({x, y - 1});
      const bool corner = !grid.is_free({x - 1, y - 1});
      walls += blocked && enters(p, q, left, top) ? 1 : 0;
      walls += blocked == corner && west == north && blocked != west && touches(p, q, left, top) ? 1 : 0;
      const bool along_top =
          p.y == top && q.y == top && std::min(p.x, q.x) < left + side && std::max(p.x, q.x) > left;
      const bool along_left =
          p.x == left && q.x == left && std::min(p.y, q.y) < top + side && std::max(p.y, q.y) > top;
      walls += blocked && north && along_top ? 1 : 0;
      walls += blocked && west && along_left ? 1 : 0;
    }
  }
  return walls;
}

// A point of the map whose coordinates are whole multiples of `grain` ticks.
Tick random_tick(const OccupancyGrid& grid, int grain, Stream& stream) {
  const auto coordinate = [&](int cells) {
    return ticks_per_cell + grain * stream.between(0, cells * ticks_per_cell / grain);
  };
  const std::int32_t x = coordinate(grid.width());
  return {x, coordinate(grid.height())};
}

TEST(WallMap, TicksAreFineAndExact) {
  EXPECT_EQ(tick_of(Cell{0, 0}), (Tick{1536, 1536}));
  EXPECT_EQ(point_of(tick_of(Cell{7, 3})), (Point{7, 3}));
  EXPECT_EQ(point_of(Tick{1024, 2049}), (Point{-0.5, 0.5009765625}));
}

TEST(WallMap, CountsTheCellsThatASegmentEnters) {
  const OccupancyGrid grid = grid_of({"....", ".##.", "...."});
  const WallMap walls(grid);
  EXPECT_EQ(walls.cross(tick_of(Cell{0, 0}), tick_of(Cell{3, 0})), (Crossing{0, 4}));
  EXPECT_EQ(walls.cross(tick_of(Cell{0, 1}), tick_of(Cell{3, 1})), (Crossing{2, 4}));
  EXPECT_EQ(walls.cross(tick_of(Cell{1, 0}), tick_of(Cell{1, 2})), (Crossing{1, 3}));
  EXPECT_EQ(walls.cross(tick_of(Cell{0, 0}), tick_of(Cell{0, 0})), (Crossing{0, 0}));
  // From (0,0) to (3,2): over (0,0), (1,0), (1,1), (2,1), (2,2), (3,2).
  EXPECT_EQ(walls.cross(tick_of(Cell{0, 0}), tick_of(Cell{3, 2})), (Crossing{2, 6}));
}

TEST(WallMap, AgreesWithAnOracleOnEverySizeOfMapAndEveryKindOfSegment) {
  for (std::uint64_t map = 0; map < 60; ++map) {
    Stream stream = Stream(31).fork(map);
    // Every third map is too wide for one word per row, every third too high.
    const int width = map % 3 == 1 ? stream.between(63, 140) : stream.between(1, 20);
    const int height = map % 3 == 2 ? stream.between(63, 140) : stream.between(1, 20);
    const OccupancyGrid grid = random_grid(stream.fork("map"), width, height, 0.35);
    const WallMap walls(grid);
    for (const int grain : {1, 64, 512, 1024}) {
      for (int k = 0; k < 60; ++k) {
        const Tick p = random_tick(grid, grain, stream);
        const Tick q = random_tick(grid, grain, stream);
        if (p == q) continue;
        ASSERT_EQ(walls.cross(p, q).walls, oracle_walls(grid, p, q))
            << map << ": " << p.x << ',' << p.y << " to " << q.x << ',' << q.y;
        ASSERT_EQ(walls.cross(q, p), walls.cross(p, q)) << map;
      }
    }
  }
}

TEST(WallMap, ASegmentThatPassesACornerByAHairIsOnItsSideOfIt) {
  // One tick before a corner of cells, with a slope of (n + 1) / n: the segment crosses the line of the
  // corner 1 / (1024 n) cells beside it, as near as a segment of n ticks can.
  for (const int size : {60, 600}) {
    const OccupancyGrid grid = random_grid(Stream(5), size, size, 0.5);
    const WallMap walls(grid);
    for (std::int32_t cell = 2; cell < 12; ++cell) {
      const std::int32_t begin = cell * ticks_per_cell - 1;
      const std::int32_t n = (size - 1) * ticks_per_cell - begin;
      for (const Tick q :
           {Tick{begin + n + 1, begin + n}, Tick{begin + n, begin + n}, Tick{begin + n, begin + n + 1}}) {
        EXPECT_EQ(walls.cross({begin, begin}, q).walls, oracle_walls(grid, {begin, begin}, q))
            << size << ' ' << cell;
      }
    }
  }
}

TEST(WallMap, CallsLegalWhatTheRefereeCallsLegal) {
  int legal = 0;
  for (std::uint64_t k = 0; k < 4000; ++k) {
    Stream stream = Stream(37).fork(k);
    const testing::Question question = testing::random_question(stream.fork("map"), 9, 0.3);
    const WallMap walls(question.grid);
    const Tick middle = random_tick(question.grid, k % 2 == 0 ? 512 : 1, stream);
    const Tick start = tick_of(question.start);
    const Tick goal = tick_of(question.goal);
    if (middle == start || middle == goal) continue;
    const Path path{Track::any_angle, {centre(question.start), point_of(middle), centre(question.goal)}};
    const bool clear = walls.cross(start, middle).walls + walls.cross(middle, goal).walls == 0;
    const Judgement judgement = Referee(terrain_of(question.grid)).judge(path, question.start, question.goal);
    ASSERT_EQ(clear, judgement.legal()) << k << ": " << judgement.fault;
    legal += clear ? 1 : 0;
  }
  EXPECT_GT(legal, 400);
}

}  // namespace
}  // namespace pathrace::algorithms
