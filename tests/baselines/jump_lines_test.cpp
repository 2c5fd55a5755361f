// Runs along rows and columns, against a walk cell by cell.
#include "baselines/grid/jump_lines.hpp"

#include <gtest/gtest.h>

#include "tests/support/maps.hpp"

namespace pathrace::testing {
namespace {

using baselines::CanonicalMoves;
using baselines::JumpMap;
using baselines::Run;

struct Walk {
  const OccupancyGrid& grid;
  const CanonicalMoves& moves;
  const std::vector<std::uint8_t>& neighbours;

  Run run(Cell cell, std::size_t direction) const {
    for (int steps = 1;; ++steps) {
      cell = {cell.x + directions[direction].x, cell.y + directions[direction].y};
      if (!grid.is_free(cell)) return {steps, false};
      const unsigned after = moves.after(static_cast<unsigned>(direction), neighbours[grid.index(cell)]);
      if ((after & ~(1U << direction)) != 0) return {steps, true};
    }
  }
};

template <int direction>
void expect_walked(const JumpMap& map, const Walk& walk, Cell cell) {
  const Run expected = walk.run(cell, direction);
  const Run run = map.run<direction>(cell);
  ASSERT_EQ(run.steps, expected.steps) << cell.x << ',' << cell.y << ' ' << direction;
  ASSERT_EQ(run.at_jump_point, expected.at_jump_point) << cell.x << ',' << cell.y << ' ' << direction;
}

TEST(JumpMap, RunsEndWhereAWalkDoesOnMapsOfEveryWidth) {
  for (std::uint64_t i = 0; i < 24; ++i) {
    const int side = static_cast<int>(1 + i * 11);  // up to 254: several machine words
    const OccupancyGrid grid = random_grid(Stream(79).fork(i), side, 1 + 260 / side, i % 2 == 0 ? 0.02 : 0.3);
    const std::vector<std::uint8_t> neighbours = baselines::free_neighbours(grid);
    for (const MoveRule rule : all_rules) {
      const CanonicalMoves& moves = CanonicalMoves::of(rule);
      const JumpMap map(grid, moves, neighbours);
      const Walk walk{grid, moves, neighbours};
      for (const Cell cell : free_cells_of(grid)) {
        expect_walked<0>(map, walk, cell);
        expect_walked<2>(map, walk, cell);
        expect_walked<4>(map, walk, cell);
        expect_walked<6>(map, walk, cell);
      }
    }
  }
}

TEST(JumpMap, AFlagStopsRunsAsLongAsItLives) {
  const OccupancyGrid grid(200, 3);
  const std::vector<std::uint8_t> neighbours = baselines::free_neighbours(grid);
  JumpMap map(grid, CanonicalMoves::of(MoveRule::strict), neighbours);
  {
    const JumpMap::Flag flag(map, {150, 1});
    EXPECT_EQ(map.run<0>({10, 1}).steps, 140);
    EXPECT_TRUE(map.run<0>({10, 1}).at_jump_point);
    EXPECT_EQ(map.run<4>({199, 1}).steps, 49);
    EXPECT_EQ(map.run<2>({150, 0}).steps, 1);
    EXPECT_EQ(map.run<6>({150, 2}).steps, 1);
  }
  EXPECT_EQ(map.run<0>({10, 1}).steps, 190);
  EXPECT_FALSE(map.run<0>({10, 1}).at_jump_point);
  EXPECT_EQ(map.run<4>({199, 1}).steps, 200);
}

}  // namespace
}  // namespace pathrace::testing
