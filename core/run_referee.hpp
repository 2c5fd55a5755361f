// The referee of dynamic worlds: judges a run from the robot's positions alone.
//
// It moves the world again from its id, so that nothing a navigator did can have changed it, and shares no
// code with navigators. In step k the world moves from state k - 1 to state k, then the robot drives from
// position k - 1 to position k while the discs stand at state k.
//
// A collision: the robot's centre, swept along its step, comes nearer to a disc's centre than the sum of the
// radii, and nearer than it was when the step began: leaving a disc that ran into the robot is no collision.
// Struck: the same with the roles changed, a disc's move against the robot that stands. Touching is neither.
//
// An oscillation: a step that ends within half of V_robot of an earlier position, after the robot had been
// farther from there.
#pragma once

#include <string>
#include <vector>

#include "core/run_metrics.hpp"
#include "core/world.hpp"

namespace pathrace {

struct RunJudgement {
  std::string fault;  ///< empty when the run kept the rules; collisions are counted, and no fault
  bool arrived = false;
  RunMetrics metrics;     ///< of a run without a fault
  std::string collision;  ///< the first one, in words
};

/// `points`: the robot's positions, the start included, one more than steps.
RunJudgement judge_run(const World& world, const std::vector<Point>& points);

}  // namespace pathrace
