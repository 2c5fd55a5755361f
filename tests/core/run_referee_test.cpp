// The referee of dynamic worlds: each fault, and each figure by hand.
#include "core/run_referee.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/world_motion.hpp"
#include "tests/support/worlds.hpp"

namespace pathrace {
namespace {

using testing::still_world;

World with_discs(std::vector<Disc> discs) {
  World world = still_world();
  world.discs = std::move(discs);
  return *settled(std::move(world), "test");
}

World empty_world() {
  return with_discs({});
}

std::vector<Point> straight_run(int steps, double length = 3) {
  std::vector<Point> points;
  for (int k = 0; k <= steps; ++k) points.push_back({10 + length * k, 50});
  return points;
}

std::string fault_of(const World& world, const std::vector<Point>& points) {
  return judge_run(world, points).fault;
}

TEST(RunReferee, MeasuresAStraightRun) {
  // 80 apart, threshold 3: arrived when 77 are driven, with the 26th step of 3.
  const RunJudgement judgement = judge_run(empty_world(), straight_run(26));
  EXPECT_EQ(judgement.fault, "");
  EXPECT_TRUE(judgement.arrived);
  EXPECT_EQ(judgement.metrics.steps, 26U);
  EXPECT_DOUBLE_EQ(judgement.metrics.travelled, 78);
  EXPECT_EQ(judgement.metrics.collisions, 0U);
  EXPECT_EQ(judgement.metrics.struck, 0U);
  EXPECT_EQ(judgement.metrics.oscillations, 0U);
  EXPECT_FALSE(judgement.metrics.min_clearance.has_value());
  EXPECT_EQ(judgement.metrics.world_hash, empty_world().hash);
}

TEST(RunReferee, ARunThatStopsShortHasNotArrivedAndIsNoFault) {
  const RunJudgement judgement = judge_run(empty_world(), straight_run(25));
  EXPECT_EQ(judgement.fault, "");
  EXPECT_FALSE(judgement.arrived);
}

TEST(RunReferee, ArrivedIsWhoIsNoFartherThanTheThreshold) {
  std::vector<Point> points = straight_run(25);  // up to 85,50
  points.push_back({87, 50});                    // 3 from the goal at 90,50
  EXPECT_TRUE(judge_run(empty_world(), points).arrived);
  points.back().x = 86.999;
  EXPECT_FALSE(judge_run(empty_world(), points).arrived);
}

TEST(RunReferee, ArrivalIsAtTheGoalAsItIsAfterItsMove) {
  World world = still_world();
  world.goal = {14, 50};
  world.goal_law = GoalLaw::way_points;
  world.way_points = {{90, 50}};
  world.goal_chance = 1;
  world.goal_step = 1;
  world = *settled(world, "test");
  EXPECT_TRUE(judge_run(world, {{10, 50}, {12, 50}}).arrived);     // the goal is at 15,50 by then
  EXPECT_FALSE(judge_run(world, {{10, 50}, {11.5, 50}}).arrived);  // 2.5 from where it was
}

TEST(RunReferee, AnEmptyRunIsAFault) {
  EXPECT_EQ(fault_of(empty_world(), {}), "the run is empty");
}

TEST(RunReferee, ARunBeginsAtTheStart) {
  EXPECT_NE(fault_of(empty_world(), {{11, 50}, {12, 50}}).find("not at the start 10,50"), std::string::npos);
}

TEST(RunReferee, AStepIsNoLongerThanTheRobotIsFast) {
  EXPECT_EQ(fault_of(empty_world(), {{10, 50}, {13, 50}}), "");
  EXPECT_NE(fault_of(empty_world(), {{10, 50}, {13.001, 50}}).find("longer than V_robot = 3"),
            std::string::npos);
}

TEST(RunReferee, TheRobotStaysInTheWorkspaceWholly) {
  World world = still_world();
  world.start = {2, 50};
  world = *settled(world, "test");
  EXPECT_EQ(fault_of(world, {{2, 50}, {1, 50}}), "");
  EXPECT_NE(fault_of(world, {{2, 50}, {0.9, 50}}).find("outside the workspace"), std::string::npos);
}

TEST(RunReferee, PositionsThatAreNoNumbersAreOutside) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(fault_of(empty_world(), {{10, 50}, {nan, 50}}).find("outside the workspace"), std::string::npos);
  EXPECT_NE(fault_of(empty_world(), {{10, 50}, {10, HUGE_VAL}}).find("outside"), std::string::npos);
}

TEST(RunReferee, NobodyDrivesOnAfterTheArrival) {
  EXPECT_NE(fault_of(empty_world(), straight_run(27)).find("arrived with step 26"), std::string::npos);
}

TEST(RunReferee, NobodyTakesMoreThanTheStepsThereAre) {
  World world = still_world();
  world.max_steps = 5;
  world = *settled(world, "test");
  EXPECT_EQ(fault_of(world, straight_run(5)), "");
  EXPECT_NE(fault_of(world, straight_run(6)).find("more than 5"), std::string::npos);
}

TEST(RunReferee, AWorldThatIsNotItsHashIsAFault) {
  World world = with_discs({{{50, 80}, 5}});
  world.discs[0].centre.x = 51;
  EXPECT_NE(fault_of(world, straight_run(3)).find("otherwise than its id says"), std::string::npos);
}

TEST(RunReferee, DiscsThatMoveOtherwiseThanTheirIdSaysAreAFault) {
  for (const GoalLaw law : {GoalLaw::random, GoalLaw::way_points, GoalLaw::flee}) {
    const World world = *settled(testing::busy_world(3, law), "test");
    const std::vector<Point> stands = {world.start, world.start};
    EXPECT_EQ(fault_of(world, stands), "") << name(law);
    World other = world;
    other.motion += 1;  // the same discs at first, on other ways
    EXPECT_NE(fault_of(other, stands).find("otherwise than its id says"), std::string::npos) << name(law);
    other = world;
    other.disc_step *= 0.5;
    EXPECT_NE(fault_of(other, stands).find("otherwise than its id says"), std::string::npos) << name(law);
  }
}

TEST(RunReferee, ADiscBetweenTheEndsOfAStepIsHit) {
  // Steps of 3 from x = 10: the disc at 11.5 lies between two positions, nearer to neither than 1.5.
  const RunJudgement judgement = judge_run(with_discs({{{11.5, 51.2}, 0.3}}), straight_run(3));
  EXPECT_EQ(judgement.fault, "");
  EXPECT_EQ(judgement.metrics.collisions, 1U);
  EXPECT_NE(judgement.collision.find("step 1, from 10,50 to 13,50 into disc 0"), std::string::npos);
  EXPECT_NEAR(*judgement.metrics.min_clearance, 1.2 - 1.3, 1e-12);
}

TEST(RunReferee, TouchingIsNoCollisionAndItsClearanceIsZero) {
  const RunJudgement judgement = judge_run(with_discs({{{20, 56}, 5}}), straight_run(26));
  EXPECT_EQ(judgement.metrics.collisions, 0U);
  EXPECT_NEAR(*judgement.metrics.min_clearance, 0, 1e-12);
}

TEST(RunReferee, EveryStepIntoADiscCountsAndLeavingItDoesNot) {
  // Disc of radius 5 around 30,50, robot of radius 1: its centre must keep 6 away, outside 24..36.
  // Steps end at 13, 16, 19, 22, 25 (in), 28 (nearer), 31 (past the centre: nearer on the way), 34, 37.
  const RunJudgement judgement = judge_run(with_discs({{{30, 50}, 5}}), straight_run(26));
  EXPECT_EQ(judgement.metrics.collisions, 3U);
  EXPECT_NEAR(*judgement.metrics.min_clearance, -6, 1e-12);
}

TEST(RunReferee, AStepIntoTwoDiscsIsTwoCollisions) {
  // Above and below 11.5,50, each 1.2 away, nearer than 0.3 + 1; the third, 1.4 away, is not touched.
  const World world = with_discs({{{11.5, 51.2}, 0.3}, {{11.5, 48.8}, 0.3}, {{14, 51.4}, 0.3}});
  const RunJudgement judgement = judge_run(world, straight_run(3));
  EXPECT_EQ(judgement.metrics.collisions, 2U);
  EXPECT_NE(judgement.collision.find("into disc 0"), std::string::npos) << judgement.collision;
}

// A world whose one disc moves 0.9 in every step, found by its direction.
World with_a_disc_that_moves_first(Disc disc, bool towards_the_robot) {
  for (std::uint64_t seed = 0;; ++seed) {
    World world = still_world();
    world.discs = {disc};
    world.disc_chance = 1;
    world.motion = seed;
    WorldMotion motion(world);
    motion.advance(world.start);
    const double before = straight_line(disc.centre, world.start);
    const double after = straight_line(motion.discs()[0].centre, world.start);
    if (towards_the_robot ? after < before - 0.8 : after > before + 0.8) return *settled(world, "test");
  }
}

TEST(RunReferee, ADiscThatRunsIntoAStandingRobotStrikesItAndTheRobotIsNotToBlame) {
  const World world = with_a_disc_that_moves_first({{10, 56.5}, 5}, true);  // gap 0.5, moves by 0.9
  const RunJudgement stays = judge_run(world, {{10, 50}, {10, 50}});
  EXPECT_EQ(stays.metrics.struck, 1U);
  EXPECT_EQ(stays.metrics.collisions, 0U);
  EXPECT_LT(*stays.metrics.min_clearance, 0);
  const RunJudgement leaves = judge_run(world, {{10, 50}, {10, 47}});
  EXPECT_EQ(leaves.metrics.struck, 1U);
  EXPECT_EQ(leaves.metrics.collisions, 0U);
  const RunJudgement drives_deeper = judge_run(world, {{10, 50}, {10, 51}});
  EXPECT_EQ(drives_deeper.metrics.collisions, 1U);
}

TEST(RunReferee, ADiscThatMovesAwayStrikesNobody) {
  const World world = with_a_disc_that_moves_first({{10, 56.1}, 5}, false);
  EXPECT_EQ(judge_run(world, {{10, 50}, {10, 50}}).metrics.struck, 0U);
}

TEST(RunReferee, TheRobotMeetsTheDiscsWhereTheyAreAfterTheirMove) {
  // The disc begins 2.5 above the robot's way and comes down by 0.9 at most: hit only where it is now.
  const World world = with_a_disc_that_moves_first({{13, 56.5}, 5}, true);
  WorldMotion motion(world);
  motion.advance(world.start);
  const Point disc = motion.discs()[0].centre;
  const RunJudgement judgement = judge_run(world, {{10, 50}, {13, 50}});
  const double gap = std::abs(disc.y - 50) - 6;  // its foot lies within the step: x in 12..13
  EXPECT_LE(disc.x, 13);
  EXPECT_EQ(judgement.metrics.collisions, gap < 0 ? 1U : 0U);
}

TEST(RunReferee, ComingBackToAPlaceIsAnOscillationAndWaitingIsNot) {
  const World world = empty_world();
  EXPECT_EQ(judge_run(world, {{10, 50}, {10, 50}, {10, 50}, {10, 50}}).metrics.oscillations, 0U);
  EXPECT_EQ(judge_run(world, {{10, 50}, {13, 50}, {10, 50}}).metrics.oscillations, 1U);
  EXPECT_EQ(judge_run(world, {{10, 50}, {13, 50}, {10, 50}, {13, 50}, {10, 50}}).metrics.oscillations, 3U);
  EXPECT_EQ(judge_run(world, {{10, 50}, {13, 50}, {11.4, 50}}).metrics.oscillations, 1U);  // within 1.5
  EXPECT_EQ(judge_run(world, {{10, 50}, {13, 50}, {11.6, 50}}).metrics.oscillations, 0U);  // 1.6 away
}

}  // namespace
}  // namespace pathrace
