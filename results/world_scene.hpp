// What a run looked like: the world moved again beside the robot's positions.
#pragma once

#include <vector>

#include "core/world.hpp"

namespace pathrace::results {

struct WorldScene {
  std::vector<Disc> discs;                      ///< after the last step
  std::vector<std::vector<Point>> disc_trails;  ///< of the moving discs: their centres, one point per move
  Point goal;                                   ///< after the last step
  std::vector<Point> goal_trail;
};

/// `points`: the robot's positions, the start included; empty: the world before it moves.
WorldScene scene_of(const World& world, const std::vector<Point>& points);

}  // namespace pathrace::results
