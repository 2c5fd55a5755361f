// Navigators: planners of dynamic worlds. A snapshot and a context in, the robot's next position out.
//
// The world stands still while the robot steps: a navigator plans on a frozen snapshot and never learns what
// the discs and the goal will do next.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>

#include "core/disc.hpp"
#include "core/planner.hpp"

namespace pathrace {

/// What a navigator sees before its step. One unit of length everywhere; the workspace is
/// [0, width] x [0, height], and the robot is a disc that stays inside it.
struct Snapshot {
  double width = 0;
  double height = 0;
  Point robot;              ///< its centre
  double robot_radius = 0;  ///< 0: a point
  double robot_step = 0;    ///< V_robot, the longest step
  Point goal;
  double arrival = 0;           ///< the robot has arrived when it is no farther from the goal than this
  std::span<const Disc> discs;  ///< valid during the call only
  std::uint64_t step = 0;       ///< counts from 0
};

/// One object steers one run, so that it may remember what it saw.
class Navigator {
 public:
  Navigator() = default;
  Navigator(const Navigator&) = delete;
  Navigator& operator=(const Navigator&) = delete;
  virtual ~Navigator() = default;

  /// Where the robot's centre goes in this step; to stay, `snapshot.robot`. The context's stream belongs to
  /// this step alone: draw from it freely, no fork by the step is needed. Spend evaluations (candidate steps
  /// judged) and checks (discs or cells tested) at the meter, and spend no more than it admits. The harness
  /// ends one iteration per step and records the trace (the distance to the goal): leave `end_iteration`
  /// and `improved` to it. When the meter is exhausted, return the best step known; the run ends with it.
  virtual Point next(const Snapshot& snapshot, Context& context) = 0;
};

using NavigatorMaker = std::function<std::unique_ptr<Navigator>()>;

}  // namespace pathrace
