// The reference search against the oracle and against optima stated by others, and the symmetries that any
// shortest path has.

#include <gtest/gtest.h>

#include <optional>
#include <string>

#include "core/reference/exact_search.hpp"
#include "tests/support/maps.hpp"
#include "tests/support/oracle.hpp"

namespace pathrace {
namespace {

using testing::all_rules;
using testing::Question;
using testing::terrain_of;

constexpr std::uint64_t maps = 600;

Question question(std::uint64_t i) {
  return testing::random_question(Stream(20).fork(i), 9, 0.6);
}

std::optional<LatticeLength> proven(const OccupancyGrid& grid, MoveRule rule, Cell start, Cell goal) {
  const Optimum optimum = reference::optimum(terrain_of(grid, rule), start, goal);
  EXPECT_TRUE(optimum.proven);
  return optimum.length;
}

std::optional<LatticeLength> proven(const Question& asked, MoveRule rule) {
  return proven(asked.grid, rule, asked.start, asked.goal);
}

std::string text(std::optional<LatticeLength> length) {
  return length ? std::to_string(length->straight) + "+" + std::to_string(length->diagonal) + "r2" : "no way";
}

// Nothing counts as longer than everything.
bool shorter(std::optional<LatticeLength> a, std::optional<LatticeLength> b) {
  if (!a || !b) return a.has_value() && !b.has_value();
  return testing::sign_of(a->straight - b->straight, a->diagonal - b->diagonal) < 0;
}

template <typename Check>
void for_random_questions(Check check) {
  for (std::uint64_t i = 0; i < maps; ++i) {
    for (const MoveRule rule : all_rules) {
      SCOPED_TRACE("map " + std::to_string(i) + " under " + std::string(name(rule)));
      check(question(i), rule);
      if (::testing::Test::HasFailure()) return;
    }
  }
}

TEST(Reference, EqualsTheOracleOnRandomMapsUnderEveryRule) {
  int ways = 0;
  int dead_ends = 0;
  for_random_questions([&](const Question& asked, MoveRule rule) {
    const auto found = proven(asked, rule);
    ++(found ? ways : dead_ends);
    EXPECT_EQ(text(found), text(testing::oracle_optimum(asked.grid, rule, asked.start, asked.goal)));
    EXPECT_EQ(found.has_value(), testing::oracle_reachable(asked.grid, rule, asked.start, asked.goal));
  });
  EXPECT_GT(ways, 500);
  EXPECT_GT(dead_ends, 100);
}

TEST(Reference, FindsTheStatedOptimaOfTheReferenceMaps) {
  ASSERT_EQ(testing::reference_maps().size(), 12U);
  for (const testing::ReferenceMap& map : testing::reference_maps()) {
    const OccupancyGrid grid = testing::grid_of(map.rows);
    for (const MoveRule rule : all_rules) {
      EXPECT_EQ(text(proven(grid, rule, map.start, map.goal)), text(map.optimum(rule)))
          << map.name << " under " << name(rule);
    }
  }
}

TEST(Oracle, FindsTheStatedOptimaOfTheReferenceMaps) {
  for (const testing::ReferenceMap& map : testing::reference_maps()) {
    const OccupancyGrid grid = testing::grid_of(map.rows);
    for (const MoveRule rule : all_rules) {
      EXPECT_EQ(text(testing::oracle_optimum(grid, rule, map.start, map.goal)), text(map.optimum(rule)))
          << map.name << " under " << name(rule);
    }
  }
}

TEST(Reference, OnAnOpenMapGoesDiagonallyFirstAndStraightForTheRest) {
  const OccupancyGrid open(20, 8);
  EXPECT_EQ(text(proven(open, MoveRule::strict, {0, 0}, {19, 7})), "12+7r2");
  EXPECT_EQ(text(proven(open, MoveRule::four, {0, 0}, {19, 7})), "26+0r2");
}

TEST(Reference, FromACellToItselfIsLengthZero) {
  for (const MoveRule rule : all_rules) {
    EXPECT_EQ(text(proven(OccupancyGrid(1, 1), rule, {0, 0}, {0, 0})), "0+0r2");
  }
}

TEST(Reference, OfAWalledInGoalProvesThatThereIsNoWay) {
  const OccupancyGrid grid = testing::grid_of({"...", ".##", ".#."});
  for (const MoveRule rule : {MoveRule::four, MoveRule::strict, MoveRule::squeeze}) {
    EXPECT_EQ(text(proven(grid, rule, {0, 0}, {2, 2})), "no way");
  }
}

TEST(Reference, MirroringAMapKeepsTheOptimum) {
  for_random_questions([](const Question& asked, MoveRule rule) {
    EXPECT_EQ(text(proven(testing::mirrored(asked), rule)), text(proven(asked, rule)));
  });
}

TEST(Reference, TransposingAMapKeepsTheOptimum) {
  for_random_questions([](const Question& asked, MoveRule rule) {
    EXPECT_EQ(text(proven(testing::transposed(asked), rule)), text(proven(asked, rule)));
  });
}

TEST(Reference, SwappingStartAndGoalKeepsTheOptimum) {
  for_random_questions([](const Question& asked, MoveRule rule) {
    EXPECT_EQ(text(proven(asked.grid, rule, asked.goal, asked.start)), text(proven(asked, rule)));
  });
}

TEST(Reference, AddingAnObstacleNeverLowersTheOptimum) {
  int raised = 0;
  std::uint64_t draw = 0;
  for_random_questions([&](const Question& asked, MoveRule rule) {
    Stream stream = Stream(21).fork(draw++);
    Question harder = asked;
    const std::vector<Cell> cells = testing::free_cells_of(asked.grid);
    const Cell added = cells[stream.below(cells.size())];
    if (added == asked.start || added == asked.goal) return;
    harder.grid.block(added);
    EXPECT_FALSE(shorter(proven(harder, rule), proven(asked, rule)));
    raised += shorter(proven(asked, rule), proven(harder, rule)) ? 1 : 0;
  });
  EXPECT_GT(raised, 50);
}

TEST(Reference, AStricterRuleNeverLowersTheOptimum) {
  for (std::uint64_t i = 0; i < maps; ++i) {
    const Question asked = question(i);
    EXPECT_FALSE(shorter(proven(asked, MoveRule::squeeze), proven(asked, MoveRule::free))) << i;
    EXPECT_FALSE(shorter(proven(asked, MoveRule::strict), proven(asked, MoveRule::squeeze))) << i;
    EXPECT_FALSE(shorter(proven(asked, MoveRule::four), proven(asked, MoveRule::strict))) << i;
  }
}

}  // namespace
}  // namespace pathrace
