// Walkers off the beaten track: what ants do that are stuck, and how steps back are counted.
#include <gtest/gtest.h>

#include "algorithms/aco/walker.hpp"
#include "tests/algorithms/walk_field.hpp"
#include "tests/support/maps.hpp"
#include "tests/support/oracle.hpp"

namespace pathrace::algorithms {
namespace {

using pathrace::testing::grid_of;

TEST(WalkerOffTrack, DiesInADeadEndWhenToldTo) {
  const WalkField field(grid_of({"...", "##.", "..."}), MoveRule::four, {1, 0}, {0, 0},
                        [](std::size_t, int d) { return d == 0 ? 1e9 : 1e-9; });
  EXPECT_FALSE(field.walk(DeadEnd::die, 1, 1)[0].arrived);
}

TEST(WalkerOffTrack, BacktrackingArrivesOnEveryConnectedMap) {
  int solvable = 0;
  for (std::uint64_t i = 0; i < 200; ++i) {
    const testing::Question question = testing::random_question(Stream(47).fork(i), 15, 0.4);
    if (question.start == question.goal) continue;
    const WalkField field(question.grid, MoveRule::strict, question.start, question.goal);
    const Walk walk = field.walk(DeadEnd::backtrack, 1, i)[0];
    const bool reachable =
        testing::oracle_reachable(question.grid, MoveRule::strict, question.start, question.goal);
    EXPECT_EQ(walk.arrived, reachable) << i;
    EXPECT_EQ(walk.pops, walk.popped.size());
    if (walk.arrived) {
      EXPECT_EQ(walk.decisions, walk.directions.size() + 2 * walk.pops) << i;  // forwards, and forth and back
    }
    field.expect_simple_and_legal(walk);
    solvable += reachable ? 1 : 0;
  }
  EXPECT_GT(solvable, 50);
}

// A corridor to the goal with a blind alley beside it.
const std::vector<std::string> alley = {"..........", ".########.", ".........#", "########.#", ".........#"};

TEST(WalkerOffTrack, LoopErasureLeavesASimpleLegalPath) {
  const WalkField field(grid_of(alley), MoveRule::strict, {0, 0}, {9, 0});
  bool turned_back = false;
  for (const Walk& walk : field.walk(DeadEnd::revisit_with_loop_erasure, 200, 59)) {
    ASSERT_TRUE(walk.arrived);
    field.expect_simple_and_legal(walk);
    turned_back = turned_back || walk.decisions > walk.directions.size();
  }
  EXPECT_TRUE(turned_back);  // some walks did go into the alley
}

TEST(WalkerOffTrack, StepsTakenBackAreListedInTheirOrder) {
  // Two blind cells behind the start; the ant is drawn into them and out again.
  const WalkField field(grid_of({"....."}), MoveRule::four, {2, 0}, {4, 0},
                        [](std::size_t, int d) { return d == 4 ? 1e9 : 1e-9; });
  const Walk walk = field.walk(DeadEnd::backtrack, 1, 5)[0];
  ASSERT_TRUE(walk.arrived);
  const auto cell = [&](int x) { return static_cast<std::uint32_t>(field.grid.index({x, 0})); };
  EXPECT_EQ(walk.popped, (std::vector<Step>{{cell(1), 4}, {cell(2), 4}}));
  EXPECT_EQ(walk.directions, (std::vector<std::uint8_t>{0, 0}));
}

TEST(WalkerOffTrack, CountsTheStepsThatAreTakenBackWhetherItListsThemOrNot) {
  WalkField field(testing::random_grid(Stream(67), 20, 20, 0.3), MoveRule::strict, {0, 0}, {19, 19});
  field.let_every_step_weigh();
  for (const std::uint64_t limit : {std::uint64_t{100}, no_limit}) {
    Ground ground = field.ground(DeadEnd::backtrack);
    const std::vector<Walk> listed = WalkField::walk_on(ground, 200, 61, limit, 4);
    ground.keep_popped = false;
    const std::vector<Walk> counted = WalkField::walk_on(ground, 200, 61, limit, 4);
    std::size_t pops = 0;
    for (std::size_t ant = 0; ant < listed.size(); ++ant) {
      EXPECT_EQ(listed[ant].pops, listed[ant].popped.size()) << ant;
      EXPECT_EQ(counted[ant].pops, listed[ant].pops) << ant;
      pops += listed[ant].pops;
    }
    EXPECT_GT(pops, 0U);
  }
}

// All that can be reached is a pocket of three cells: there and back, and one decision more to find that out.
TEST(WalkerOffTrack, WhoHasSeenAllHasTakenEveryStepBack) {
  WalkField field(grid_of({"...#."}), MoveRule::four, {0, 0}, {4, 0});
  field.let_every_step_weigh();
  for (const bool keep_popped : {false, true}) {
    Ground ground = field.ground(DeadEnd::backtrack);
    ground.keep_popped = keep_popped;
    for (const Walk& walk : WalkField::walk_on(ground, 3, 1, no_limit, 2)) {
      EXPECT_FALSE(walk.arrived);
      EXPECT_EQ(walk.decisions, 5U);
      EXPECT_EQ(walk.pops, 2U);
    }
  }
}

TEST(WalkerOffTrack, WithoutStepsBackNoneAreCounted) {
  const WalkField field(testing::random_grid(Stream(67), 20, 20, 0.3), MoveRule::strict, {0, 0}, {19, 19});
  for (const DeadEnd dead_end : {DeadEnd::die, DeadEnd::revisit_with_loop_erasure}) {
    for (const Walk& walk : field.walk(dead_end, 200, 61, 500)) EXPECT_EQ(walk.pops, 0U) << name(dead_end);
  }
}

TEST(WalkerOffTrack, StillChoosesWhenEveryWeightHasUnderflown) {
  WalkField field(grid_of({"....."}), MoveRule::four, {0, 0}, {4, 0});
  field.trail.evaporate(0);
  EXPECT_TRUE(field.walk(DeadEnd::die, 1, 1)[0].arrived);
}

}  // namespace
}  // namespace pathrace::algorithms
