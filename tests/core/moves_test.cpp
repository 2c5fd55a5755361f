// The planners' table of legal steps against the oracle's spelling of the four rules.

#include "core/moves.hpp"

#include <gtest/gtest.h>

#include "tests/support/maps.hpp"
#include "tests/support/oracle.hpp"

namespace pathrace {
namespace {

using testing::all_rules;
using testing::grid_of;
using testing::oracle_step;

int legal_steps(const OccupancyGrid& grid, MoveRule rule, Cell cell) {
  return MoveTable(grid, rule)[grid.index(cell)];
}

TEST(Directions, GoRoundClockwiseFromTheEastInEighths) {
  EXPECT_EQ(directions[0], (Cell{1, 0}));
  EXPECT_EQ(directions[2], (Cell{0, 1}));  // y grows downwards, so south
  EXPECT_EQ(directions[7], (Cell{1, -1}));
  for (int d = 0; d < direction_count; ++d) {
    const Cell step = directions[static_cast<std::size_t>(d)];
    const Cell back = directions[static_cast<std::size_t>(opposite(d))];
    EXPECT_EQ((Cell{-step.x, -step.y}), back);
    EXPECT_EQ(is_diagonal(d), step.x != 0 && step.y != 0);
  }
}

void expect_oracle_steps(const OccupancyGrid& grid, MoveRule rule) {
  const MoveTable moves(grid, rule);
  ASSERT_EQ(moves.size(), grid.padded_size());
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x) {
      const std::size_t here = grid.index({x, y});
      ASSERT_EQ(moves.data()[here], moves[here]);
      for (int d = 0; d < direction_count; ++d) {
        const Cell step = directions[static_cast<std::size_t>(d)];
        const Cell to{x + step.x, y + step.y};
        ASSERT_EQ((moves[here] >> d & 1) != 0, oracle_step(grid, rule, {x, y}, to))
            << name(rule) << " " << x << "," << y << " direction " << d;
        if (!grid.blocked_at(here)) {
          ASSERT_EQ(moves.step(here, d), grid.index(to));
        }
      }
    }
  }
}

TEST(MoveTable, AgreesWithTheOracleOnRandomMapsUnderEveryRule) {
  const Stream seeds(1);
  for (std::uint64_t i = 0; i < 200; ++i) {
    const testing::Question question = testing::random_question(seeds.fork(i), 12, 0.8);
    for (const MoveRule rule : all_rules) expect_oracle_steps(question.grid, rule);
    if (HasFatalFailure()) FAIL() << "map " << i;
  }
}

// The bits of E, SE, S, ..., NE, added by hand.
TEST(MoveTable, HandDrawnCorners) {
  const OccupancyGrid one_side = grid_of({".#", ".."});
  EXPECT_EQ(legal_steps(one_side, MoveRule::four, {0, 0}), 4);     // S
  EXPECT_EQ(legal_steps(one_side, MoveRule::strict, {0, 0}), 4);   // S
  EXPECT_EQ(legal_steps(one_side, MoveRule::squeeze, {0, 0}), 6);  // SE, S
  EXPECT_EQ(legal_steps(one_side, MoveRule::free, {0, 0}), 6);     // SE, S
  const OccupancyGrid both_sides = grid_of({".#", "#."});
  EXPECT_EQ(legal_steps(both_sides, MoveRule::squeeze, {0, 0}), 0);
  EXPECT_EQ(legal_steps(both_sides, MoveRule::free, {0, 0}), 2);  // SE
  const OccupancyGrid open(3, 3);
  EXPECT_EQ(legal_steps(open, MoveRule::strict, {1, 1}), 255);
  EXPECT_EQ(legal_steps(open, MoveRule::four, {1, 1}), 1 + 4 + 16 + 64);
  EXPECT_EQ(legal_steps(open, MoveRule::free, {0, 0}), 1 + 2 + 4);
}

TEST(MoveTable, NoStepLeavesABlockedCellOrTheFrame) {
  const OccupancyGrid grid = grid_of({"#.", ".."});
  const MoveTable moves(grid, MoveRule::free);
  EXPECT_EQ(moves[grid.index({0, 0})], 0);
  EXPECT_EQ(moves[grid.index({-1, 0})], 0);
  EXPECT_EQ(moves[grid.index({2, 2})], 0);
}

}  // namespace
}  // namespace pathrace
