// Which steps remain from a cell, in cases worked out by hand.
#include "baselines/grid/canonical_moves.hpp"

#include <gtest/gtest.h>

#include <initializer_list>

#include "tests/support/maps.hpp"
#include "tests/support/oracle.hpp"

namespace pathrace::testing {
namespace {

enum Direction : unsigned { e, se, s, sw, w, nw, n, ne };

constexpr unsigned mask_of(std::initializer_list<unsigned> of) {
  unsigned mask = 0;
  for (const unsigned direction : of) mask |= 1U << direction;
  return mask;
}

unsigned after(MoveRule rule, Direction arrival, std::initializer_list<unsigned> blocked) {
  const auto neighbours = static_cast<std::uint8_t>(~mask_of(blocked));
  return baselines::CanonicalMoves::of(rule).after(arrival, neighbours);
}

TEST(CanonicalMoves, OnOpenGroundADiagonalFansOutAndAStraightStepRunsOn) {
  for (const MoveRule rule : {MoveRule::strict, MoveRule::squeeze, MoveRule::free}) {
    EXPECT_EQ(after(rule, se, {}), mask_of({se, e, s})) << name(rule);
    EXPECT_EQ(after(rule, e, {}), mask_of({e})) << name(rule);
    EXPECT_EQ(after(rule, n, {}), mask_of({n})) << name(rule);
  }
}

TEST(CanonicalMoves, UnderFourAHorizontalStepFansOutAndAVerticalOneRunsOn) {
  EXPECT_EQ(after(MoveRule::four, w, {}), mask_of({w, n, s}));
  EXPECT_EQ(after(MoveRule::four, s, {}), mask_of({s}));
  EXPECT_EQ(after(MoveRule::four, s, {ne}),
            mask_of({s, e}));  // from (0,-1), (1,0) is two steps this way only
}

TEST(CanonicalMoves, UnderStrictAPassedObstacleOpensTheSideBehindIt) {
  EXPECT_EQ(after(MoveRule::strict, e, {nw}), mask_of({e, n, ne}));
  EXPECT_EQ(after(MoveRule::strict, e, {n}), mask_of({e}));
  EXPECT_EQ(after(MoveRule::strict, se, {s}), mask_of({e}));
}

TEST(CanonicalMoves, WhereCornersMayBeCutTheDiagonalBehindAnObstacleRemains) {
  for (const MoveRule rule : {MoveRule::squeeze, MoveRule::free}) {
    EXPECT_EQ(after(rule, e, {n}), mask_of({e, ne})) << name(rule);
    EXPECT_EQ(after(rule, e, {nw}), mask_of({e})) << name(rule);
    EXPECT_EQ(after(rule, se, {w}), mask_of({se, e, s, sw})) << name(rule);
  }
  EXPECT_EQ(after(MoveRule::free, e, {n, e}), mask_of({ne}));
  EXPECT_EQ(after(MoveRule::squeeze, e, {n, e}), 0U);
}

TEST(CanonicalMoves, LegalStepsAreTheOracles) {
  for (unsigned pattern = 0; pattern < 256; ++pattern) {
    OccupancyGrid grid(3, 3);
    for (std::size_t d = 0; d < directions.size(); ++d) {
      if ((pattern >> d & 1) == 0) grid.block({1 + directions[d].x, 1 + directions[d].y});
    }
    EXPECT_EQ(baselines::free_neighbours(grid)[grid.index({1, 1})], pattern);
    for (const MoveRule rule : all_rules) {
      unsigned expected = 0;
      for (std::size_t d = 0; d < directions.size(); ++d) {
        const Cell to{1 + directions[d].x, 1 + directions[d].y};
        if (oracle_step(grid, rule, {1, 1}, to)) expected |= 1U << d;
      }
      EXPECT_EQ(baselines::CanonicalMoves::of(rule).legal(static_cast<std::uint8_t>(pattern)), expected);
    }
  }
}

}  // namespace
}  // namespace pathrace::testing
