// Dynamic worlds by their ids.
#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "core/world_motion.hpp"
#include "scenarios/discs/settings.hpp"
#include "scenarios/library.hpp"

namespace pathrace::scenarios {
namespace {

World world_of(const std::string& id) {
  return *Library().load(id).world;
}

std::string refusal(const std::string& id) {
  try {
    Library().load(id);
  } catch (const InputError& fault) {
    return fault.what();
  }
  return "";
}

std::size_t touching_neighbours(const World& world, std::size_t index) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < world.discs.size(); ++i) {
    if (i == index) continue;
    const double gap = straight_line(world.discs[i].centre, world.discs[index].centre) -
                       world.discs[i].radius - world.discs[index].radius;
    count += std::abs(gap) < 1e-9 ? 1 : 0;
  }
  return count;
}

TEST(Discs, DefaultsAreThoseOfTheSpecification) {
  const World world = world_of("discs/open/1");
  EXPECT_EQ(world.width, 100);
  EXPECT_EQ(world.height, 100);
  EXPECT_EQ(world.robot_step, 3);
  EXPECT_EQ(world.goal_step, 1.5);
  EXPECT_DOUBLE_EQ(world.disc_step, 0.9);
  EXPECT_EQ(world.arrival, 3);
  EXPECT_EQ(world.max_steps, 500U);
  EXPECT_EQ(world.discs.size(), 10U);
  for (const Disc& disc : world.discs) EXPECT_TRUE(disc.radius >= 3 && disc.radius <= 8);
}

TEST(Discs, EveryListedWorldHasItsPursuitAndRoomAroundItsEnds) {
  const Library library;
  for (const DiscsKind& kind : discs_kinds()) {
    for (int seed = 1; seed <= 30; ++seed) {
      const std::string id = "discs/" + std::string(kind.name) + "/" + std::to_string(seed);
      const Scenario scenario = library.load(id);
      const World& world = *scenario.world;
      ASSERT_TRUE(world.least_steps.has_value()) << id;
      EXPECT_GT(*world.least_steps, 5U) << id;
      EXPECT_EQ(world.goal_law == GoalLaw::flee, kind.name == "chase") << id;
      EXPECT_EQ(world.hash, world_hash(world)) << id;
      for (const Disc& disc : world.discs) {
        EXPECT_GT(straight_line(disc.centre, world.start), disc.radius + world.robot_radius) << id;
        EXPECT_GT(straight_line(disc.centre, world.goal), disc.radius + world.robot_radius) << id;
      }
    }
  }
}

TEST(Discs, ARingClosesWithTouchingDiscsAroundWhomItSays) {
  for (const char* id : {"discs/ring/1", "discs/ring,inside=robot/1", "discs/ring,inside=goal/1"}) {
    const World world = world_of(id);
    ASSERT_EQ(world.walls, 12U) << id;
    for (std::size_t i = 0; i < 12; ++i) EXPECT_EQ(touching_neighbours(world, i), 2U) << id << ' ' << i;
  }
  const Point middle{50, 50};
  EXPECT_EQ(world_of("discs/ring,inside=robot/1").start, middle);
  EXPECT_EQ(world_of("discs/ring,inside=goal/1").goal, middle);
  EXPECT_GT(straight_line(world_of("discs/ring/1").start, middle), 30);
}

TEST(Discs, ACTrapOpensToTheRobotAndItsGapsAdmitIt) {
  const World world = world_of("discs/c-trap/2");
  ASSERT_EQ(world.discs.size(), 9U);
  for (std::size_t i = 0; i < world.discs.size(); ++i) EXPECT_EQ(touching_neighbours(world, i), 0U);
  double least = 100;
  for (std::size_t i = 1; i < world.discs.size(); ++i) {
    least = std::min(
        least, straight_line(world.discs[i].centre, world.discs[i - 1].centre) - 2 * world.discs[i].radius);
    EXPECT_FALSE(world.discs[i].centre.x < 33 && std::abs(world.discs[i].centre.y - world.start.y) < 5);
  }
  EXPECT_NEAR(least, 3, 1e-9);
  EXPECT_GT(least, 2 * world.robot_radius);
}

TEST(Discs, InACorridorAllThatMovesStaysBetweenTheWalls) {
  const World world = world_of("discs/corridor/3");
  ASSERT_EQ(world.walls, 20U);
  ASSERT_EQ(world.discs.size(), 26U);
  WorldMotion motion(world);
  for (std::uint64_t k = 0; k < world.max_steps; ++k) {
    motion.advance(world.start);
    for (std::size_t i = world.walls; i < world.discs.size(); ++i) {
      EXPECT_LT(std::abs(motion.discs()[i].centre.y - 50), 12 + 5);
    }
    EXPECT_LT(std::abs(motion.goal().y - 50), 12 + 5);
  }
}

TEST(Discs, AnIdMayChangeWhatItNames) {
  const World world = world_of("discs/open,discs=3,r_max=4,robot_radius=0.5,v_robot=2,v_obs=1,p_obs=0.75/9");
  EXPECT_EQ(world.discs.size(), 3U);
  EXPECT_EQ(world.robot_radius, 0.5);
  EXPECT_EQ(world.robot_step, 2);
  EXPECT_EQ(world.goal_step, 1);  // shares of V_robot follow it
  EXPECT_EQ(world.disc_step, 2);
  EXPECT_EQ(world.arrival, 2);
  EXPECT_EQ(world.disc_chance, 0.75);
  EXPECT_EQ(world_of("discs/open,goal=way_points/1").way_points.size(), 4U);
}

TEST(Discs, OneQuestionHasOneId) {
  EXPECT_NE(refusal("discs/open,p_obs=0.5/1").find("write its middle part as open"), std::string::npos);
  EXPECT_NE(refusal("discs/dense,discs=30/1").find("write its middle part as dense"), std::string::npos);
  EXPECT_EQ(refusal("discs/dense,discs=10/1"), "");
  EXPECT_NE(refusal("discs/open,p_obs=0.25,discs=3/1").find("open,discs=3,p_obs=0.25"), std::string::npos);
  EXPECT_NE(refusal("discs/open,p_obs=.25/1").find("p_obs=0.25"), std::string::npos);
}

TEST(Discs, WhatDoesNotFitIsRefusedInOneLine) {
  EXPECT_NE(refusal("discs/opne/1").find("nearest match is 'open'"), std::string::npos);
  EXPECT_NE(refusal("discs/open,p_obj=1/1").find("'p_obs'"), std::string::npos);
  EXPECT_NE(refusal("discs/open,lane=30/1").find("means nothing to the kind open"), std::string::npos);
  EXPECT_NE(refusal("discs/chase,goal=random/1").find("means nothing to the kind chase"), std::string::npos);
  EXPECT_NE(refusal("discs/open,goal=flee/1").find("only there"), std::string::npos);
  EXPECT_NE(refusal("discs/open,r_min=9/1").find("r_min is greater than r_max"), std::string::npos);
  EXPECT_NE(refusal("discs/open,discs=500/1").find("no room"), std::string::npos);
  EXPECT_NE(refusal("discs/open").find("discs/<kind>[,key=value...]/<seed>"), std::string::npos);
  EXPECT_NE(refusal("discs/open,discs/1").find("key=value"), std::string::npos);
  EXPECT_NE(refusal("discs/open,discs=1,discs=2/1").find("twice"), std::string::npos);
}

TEST(Discs, TheStillPictureBlocksTheCellsWhoseCentresLieInDiscs) {
  const Scenario scenario = Library().load("discs/open/4");
  EXPECT_EQ(scenario.grid().width(), 100);
  EXPECT_FALSE(scenario.optimum.length.has_value());
  for (const Disc& disc : scenario.world->discs) {
    const Cell cell{static_cast<int>(disc.centre.x), static_cast<int>(disc.centre.y)};
    EXPECT_FALSE(scenario.grid().is_free(cell));
  }
  EXPECT_TRUE(scenario.grid().is_free(scenario.start));
  EXPECT_TRUE(scenario.grid().is_free(scenario.goal));
}

}  // namespace
}  // namespace pathrace::scenarios
