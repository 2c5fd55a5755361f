// Small dynamic worlds for tests.
#pragma once

#include <string>
#include <vector>

#include "core/scenario.hpp"
#include "core/stream.hpp"
#include "core/world.hpp"

namespace pathrace::testing {

/// 100 x 100, the robot (radius 1, V 3) at 10,50, the goal at 90,50; nothing moves and no disc is there.
inline World still_world() {
  World world;
  world.start = {10, 50};
  world.goal = {90, 50};
  world.goal_chance = 0;
  world.disc_chance = 0;
  world.motion = 7;
  return world;
}

/// The same with discs that move in every step.
inline World busy_world(std::uint64_t seed, GoalLaw law = GoalLaw::random) {
  World world = still_world();
  world.goal_law = law;
  world.goal_chance = 1;
  world.disc_chance = 1;
  world.motion = Stream(seed).place();
  world.max_steps = 200;
  world.way_points = {{90, 90}, {50, 10}, {90, 10}};
  for (const Point centre : {Point{30, 30}, {30, 70}, {50, 45}, {50, 56}, {70, 30}, {70, 70}, {60, 88}}) {
    world.discs.push_back({centre, 5});
  }
  return world;
}

/// A scenario around a world, with a still picture of no content.
inline Scenario scenario_of(World world, const std::string& id = "test") {
  Scenario scenario;
  scenario.id = id;
  scenario.terrain = {std::make_shared<const OccupancyGrid>(100, 100), MoveRule::strict};
  scenario.start = {10, 50};
  scenario.goal = {90, 50};
  scenario.world = settled(std::move(world), id);
  return scenario;
}

}  // namespace pathrace::testing
