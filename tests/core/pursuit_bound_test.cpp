// The informed pursuit, against arithmetic and against a slow oracle.
#include "core/pursuit_bound.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/world_motion.hpp"
#include "tests/support/worlds.hpp"

namespace pathrace {
namespace {

using testing::busy_world;
using testing::still_world;

TEST(PursuitBound, ToAStandingGoalIsTheDistanceLessTheThresholdInSteps) {
  World world = still_world();
  EXPECT_EQ(least_steps(world), 26U);  // (80 - 3) / 3 = 25.67
  world.goal = {10 + 3 + 30, 50};
  EXPECT_EQ(least_steps(world), 10U);  // exactly
  world.goal = {12, 50};
  EXPECT_EQ(least_steps(world), 0U);
}

TEST(PursuitBound, KnowsWhereTheGoalWillBe) {
  World world = still_world();
  world.goal_law = GoalLaw::way_points;
  world.goal_chance = 1;
  world.goal_step = 1;
  world.way_points = {{20, 50}};  // comes towards the robot: closing at 4 a step, 77 to close
  EXPECT_EQ(least_steps(world), 20U);
  world.way_points = {{98, 50}};  // flees for 8, then stands: 85 / 3
  EXPECT_EQ(least_steps(world), 29U);
}

TEST(PursuitBound, HasNoneWhenTheStepsDoNotSuffice) {
  World world = still_world();
  world.max_steps = 25;
  EXPECT_FALSE(least_steps(world).has_value());
  world.max_steps = 26;
  EXPECT_EQ(least_steps(world), 26U);
}

// A robot that sees the goal's next move before it steps, and drives at where the goal will be in k steps.
bool reaches(const World& world, std::uint64_t k) {
  WorldMotion motion(world);
  for (std::uint64_t i = 0; i < k; ++i) motion.advance(world.start);
  const double apart = straight_line(world.start, motion.goal());
  const double driven = std::min(apart, static_cast<double>(k) * world.robot_step);
  return apart - driven <= world.arrival + 1e-9;
}

TEST(PursuitBound, IsTheFirstStepInWhichAnInformedRobotCanBeThere) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const World world = busy_world(seed, seed % 2 == 0 ? GoalLaw::random : GoalLaw::way_points);
    const auto least = least_steps(world);
    ASSERT_TRUE(least.has_value());
    EXPECT_TRUE(reaches(world, *least)) << seed;
    for (std::uint64_t k = 0; k < *least; ++k) EXPECT_FALSE(reaches(world, k)) << seed << ' ' << k;
  }
}

}  // namespace
}  // namespace pathrace
