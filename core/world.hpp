// A dynamic world: a disc-shaped robot among moving discs, after a moving goal.
//
// The order of Nasrollahy and Javadi's Algorithm 2: stop where the robot has arrived; else the discs move,
// then the goal; then the robot plans on what it sees and steps. Nothing moves while it steps.
//
// How a world moves is a function of `motion` alone and the same for every navigator: discs never look at the
// robot. Only a fleeing goal looks at it; the law and its stream are then the same, the way is not.
//
// B. Nasrollahy, H. H. S. Javadi, "Using Particle Swarm Optimization for Robot Path Planning in Dynamic
// Environments with Moving Obstacles and Target", EMS 2009. The text leaves directions open: uniform.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "core/disc.hpp"
#include "core/names.hpp"

namespace pathrace {

enum class GoalLaw {
  random,      ///< each move in a new direction
  way_points,  ///< from one way-point to the next, and round again
  flee,        ///< straight away from the robot, or aslant where that is blocked; never nearer to it
};

template <>
inline constexpr auto names_of<GoalLaw> = std::to_array<std::pair<GoalLaw, std::string_view>>({
    {GoalLaw::random, "random"},
    {GoalLaw::way_points, "way_points"},
    {GoalLaw::flee, "flee"},
});

/// Lengths in one unit, speeds in units per step, chances per step. The workspace is
/// [0, width] x [0, height].
struct World {
  double width = 100;
  double height = 100;
  Point start;              ///< of the robot's centre
  double robot_radius = 1;  ///< 0: a point
  double robot_step = 3;    ///< V_robot, the longest step
  double arrival = 3;       ///< the threshold: arrived when no farther from the goal
  Point goal;               ///< where it is before its first move
  GoalLaw goal_law = GoalLaw::random;
  double goal_step = 1.5;    ///< V_goal, below V_robot
  double goal_chance = 0.5;  ///< P_goal
  std::vector<Point> way_points;
  std::vector<Disc> discs;   ///< before their first move; they may touch, and do not overlap
  std::size_t walls = 0;     ///< so many of the first discs never move
  double disc_step = 0.9;    ///< V_obs
  double disc_chance = 0.5;  ///< P_obs
  std::uint64_t max_steps = 500;
  std::uint64_t motion = 0;  ///< place of the stream that moves discs and goal

  // Filled in by `settled`.
  std::uint64_t hash = 0;                    ///< see world_hash
  std::optional<std::uint64_t> least_steps;  ///< see core/pursuit_bound.hpp
};

/// Checks a world, and computes its hash and bound. Throws InvalidScenario, with the id in front, for what
/// cannot be a world: overlapping discs, a start or goal outside or inside a disc, V_goal >= V_robot, numbers
/// that are not finite.
std::shared_ptr<const World> settled(World world, std::string_view id);

/// Hash of all that is given and of every position of discs and goal for all `max_steps`. Where the goal
/// flees, its law and stream stand for its positions.
std::uint64_t world_hash(const World& world);

/// Square root of the sum of squares: the same bits everywhere.
double straight_line(Point a, Point b);

}  // namespace pathrace
