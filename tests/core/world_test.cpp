// Dynamic worlds: what may be one, how it moves, and what its hash covers.
#include "core/world.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <set>

#include "core/error.hpp"
#include "core/world_motion.hpp"
#include "tests/support/worlds.hpp"

namespace pathrace {
namespace {

using testing::busy_world;
using testing::still_world;

std::string refusal(World world) {
  try {
    settled(std::move(world), "id");
  } catch (const InvalidScenario& fault) {
    return fault.what();
  }
  return "";
}

TEST(World, WhatCannotBeOneIsRefusedWithItsIdAndTheValue) {
  EXPECT_EQ(refusal(still_world()), "");
  const auto expect = [](const std::function<void(World&)>& spoil, const std::string& words) {
    World world = busy_world(1);
    spoil(world);
    const std::string text = refusal(world);
    EXPECT_TRUE(text.starts_with("id: ")) << text;
    EXPECT_NE(text.find(words), std::string::npos) << text;
  };
  expect([](World& w) { w.discs[1] = {{34, 30}, 5}; }, "discs 0 and 1 overlap");
  expect([](World& w) { w.discs[0].centre = {14, 50}; }, "disc 0 covers the start");
  expect([](World& w) { w.discs[0].centre = {86, 52}; }, "disc 0 covers the goal");
  expect([](World& w) { w.discs[0].centre = {3, 30}; }, "too near to the border");
  expect([](World& w) { w.discs[0].radius = 0; }, "radius 0");
  expect([](World& w) { w.start = {0.5, 50}; }, "start 0.5,50");
  expect([](World& w) { w.goal = {100, 50}; }, "goal 100,50");
  expect([](World& w) { w.goal_step = 3; }, "V_goal must be below V_robot");
  expect([](World& w) { w.disc_chance = 1.5; }, "1.5");
  expect([](World& w) { w.robot_step = std::nan(""); }, "V_robot");
  expect([](World& w) { w.walls = 9; }, "walls");
}

TEST(WorldMotion, DiscsNeverOverlapAndStayInsideAndClearOfTheGoal) {
  for (const GoalLaw law : {GoalLaw::random, GoalLaw::way_points}) {
    const World world = busy_world(3, law);
    WorldMotion motion(world);
    for (std::uint64_t k = 0; k < world.max_steps; ++k) {
      motion.advance({10, 50});
      for (std::size_t i = 0; i < motion.discs().size(); ++i) {
        const Disc& disc = motion.discs()[i];
        ASSERT_TRUE(disc.centre.x >= 5 && disc.centre.x <= 95 && disc.centre.y >= 5 && disc.centre.y <= 95);
        ASSERT_GE(straight_line(disc.centre, motion.goal()), disc.radius + world.robot_radius) << k;
        for (std::size_t j = 0; j < i; ++j) {
          ASSERT_GE(straight_line(disc.centre, motion.discs()[j].centre), 10) << k << ' ' << i << ' ' << j;
        }
      }
    }
  }
}

TEST(WorldMotion, EveryMoveIsAsLongAsTheSpeedSaysAndTheGoalKeepsInside) {
  const World world = busy_world(5);
  WorldMotion motion(world);
  std::size_t moves = 0;
  for (std::uint64_t k = 0; k < world.max_steps; ++k) {
    const std::vector<Disc> before(motion.discs().begin(), motion.discs().end());
    const Point goal = motion.goal();
    motion.advance({10, 50});
    for (std::size_t i = 0; i < before.size(); ++i) {
      const double moved = straight_line(before[i].centre, motion.discs()[i].centre);
      if (moved > 0) {
        ++moves;
        EXPECT_NEAR(moved, 0.9, 1e-12);
      }
    }
    const double moved = straight_line(goal, motion.goal());
    EXPECT_TRUE(moved == 0 || std::abs(moved - 1.5) < 1e-12) << moved;
    EXPECT_TRUE(motion.goal().x >= 1 && motion.goal().x <= 99 && motion.goal().y >= 1 &&
                motion.goal().y <= 99);
  }
  EXPECT_GT(moves, 7 * 200 * 9 / 10);  // seven discs, and hardly ever eight blocked directions
}

TEST(WorldMotion, ADiscMovesWithItsProbabilityAndWallsNever) {
  World world = busy_world(6);
  world.disc_chance = 0.25;
  world.walls = 2;
  world.max_steps = 2000;
  WorldMotion motion(world);
  std::vector<int> moves(world.discs.size(), 0);
  for (std::uint64_t k = 0; k < world.max_steps; ++k) {
    const std::vector<Disc> before(motion.discs().begin(), motion.discs().end());
    motion.advance({10, 50});
    for (std::size_t i = 0; i < before.size(); ++i) moves[i] += before[i] == motion.discs()[i] ? 0 : 1;
  }
  EXPECT_EQ(moves[0] + moves[1], 0);
  // Binomial(2000, 1/4): mean 500, standard deviation 19.4; five of them.
  for (std::size_t i = 2; i < moves.size(); ++i) EXPECT_NEAR(moves[i], 500, 97) << i;
}

TEST(WorldMotion, DirectionsHaveLengthOneAndFavourNone) {
  Stream stream(11);
  int quadrants[4] = {};
  for (int i = 0; i < 4000; ++i) {
    const Point d = draw_direction(stream);
    EXPECT_NEAR(d.x * d.x + d.y * d.y, 1, 1e-15);
    ++quadrants[(d.x > 0 ? 1 : 0) + (d.y > 0 ? 2 : 0)];
  }
  for (const int count : quadrants) EXPECT_NEAR(count, 1000, 137);  // five standard deviations
}

Point elsewhere(std::uint64_t k) {
  return {50 + 0.2 * static_cast<double>(k), 20};
}

TEST(WorldMotion, DiscsAndAGoalThatDoesNotFleeNeverLookAtTheRobot) {
  for (const GoalLaw law : {GoalLaw::random, GoalLaw::way_points, GoalLaw::flee}) {
    const World world = busy_world(8, law);
    WorldMotion one(world);
    WorldMotion other(world);
    for (std::uint64_t k = 0; k < world.max_steps; ++k) {
      one.advance({10, 50});
      other.advance(elsewhere(k));
      for (std::size_t i = 0; i < world.discs.size(); ++i) ASSERT_EQ(one.discs()[i], other.discs()[i]) << k;
      ASSERT_TRUE(law == GoalLaw::flee || one.goal() == other.goal()) << k;
    }
  }
}

TEST(WorldMotion, AFleeingGoalIsNeverNearerAfterItsMove) {
  World world = busy_world(9, GoalLaw::flee);
  WorldMotion motion(world);
  Point robot = world.start;
  for (std::uint64_t k = 0; k < world.max_steps; ++k) {
    const double before = straight_line(robot, motion.goal());
    motion.advance(robot);
    EXPECT_GE(straight_line(robot, motion.goal()), before - 1e-12) << k;
    const double apart = straight_line(robot, motion.goal());
    const double share = std::min(1.0, 3 / apart);
    robot = {robot.x + share * (motion.goal().x - robot.x), robot.y + share * (motion.goal().y - robot.y)};
  }
}

TEST(WorldMotion, AGoalGoesFromWayPointToWayPointAndRoundAgain) {
  World world = still_world();
  world.goal_law = GoalLaw::way_points;
  world.goal_chance = 1;
  world.goal_step = 2;
  world.way_points = {{90, 55}, {90, 50}};
  WorldMotion motion(world);
  std::vector<double> heights;
  for (int k = 0; k < 8; ++k) {
    motion.advance(world.start);
    heights.push_back(motion.goal().y);
  }
  EXPECT_EQ(heights, (std::vector<double>{52, 54, 55, 53, 51, 50, 52, 54}));
}

TEST(WorldMotion, AGoalGivesAWayPointUpThatADiscBlocks) {
  World world = still_world();
  world.goal_law = GoalLaw::way_points;
  world.goal_chance = 1;
  world.goal_step = 2;
  world.discs = {{{90, 60}, 5}};  // the goal may come to 6 from its centre: to y = 54
  world.way_points = {{90, 70}, {90, 46}};
  WorldMotion motion(world);
  std::vector<double> heights;
  for (int k = 0; k < 5; ++k) {
    motion.advance(world.start);
    heights.push_back(motion.goal().y);
  }
  EXPECT_EQ(heights, (std::vector<double>{52, 54, 54, 52, 50}));
}

TEST(WorldHash, MovesWithEverythingThatIsGivenAndWithThePositions) {
  const std::vector<std::function<void(World&)>> changes = {
      [](World&) {},
      [](World& w) { w.start.x += 1; },
      [](World& w) { w.robot_radius = 0.5; },
      [](World& w) { w.robot_step = 4; },
      [](World& w) { w.arrival = 2; },
      [](World& w) { w.goal.y += 1; },
      [](World& w) { w.goal_law = GoalLaw::way_points; },
      [](World& w) { w.goal_law = GoalLaw::flee; },
      [](World& w) { w.goal_step = 1; },
      [](World& w) { w.goal_chance = 0.75; },
      [](World& w) { w.way_points.pop_back(); },
      [](World& w) { w.discs.pop_back(); },
      [](World& w) { w.discs[2].radius = 4; },
      [](World& w) { w.walls = 1; },
      [](World& w) { w.disc_step = 1; },
      [](World& w) { w.disc_chance = 0.75; },
      [](World& w) { w.max_steps = 199; },
      [](World& w) { ++w.motion; },
  };
  std::set<std::uint64_t> hashes;
  for (const auto& change : changes) {
    World world = busy_world(2);
    change(world);
    hashes.insert(world_hash(world));
  }
  EXPECT_EQ(hashes.size(), changes.size());
}

TEST(WorldHash, IsWhatAMotionAddsUpToWhereverTheRobotIs) {
  for (const GoalLaw law : {GoalLaw::random, GoalLaw::way_points, GoalLaw::flee}) {
    const World world = busy_world(4, law);
    WorldMotion motion(world);
    for (int k = 0; k < 37; ++k) motion.advance({20, 20.0 + k});
    EXPECT_EQ(motion.hash_to_the_end(), world_hash(world)) << name(law);
  }
}

TEST(WorldHash, OfASettledWorldIsItsContentHash) {
  const Scenario scenario = testing::scenario_of(busy_world(4));
  EXPECT_EQ(content_hash(scenario), world_hash(busy_world(4)));
}

}  // namespace
}  // namespace pathrace
