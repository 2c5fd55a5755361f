// What a detour around discs costs: eq. (10) of Nasrollahy and Javadi.
//
// A straight leg that crosses a disc cuts its circle into two arcs. The robot could go around along either,
// so the penalty of that disc is the lesser of
//
//   arc_j + the circumferences of the discs adjacent to arc_j and of all that hang together with them,
//
// and the penalty of a particle is the sum over both its legs, robot to particle and particle to goal. The
// paper leaves open what happens when a leg ends inside a disc, and at the border; algorithms.md 4.3 has the
// reconstruction that is used here:
//  - a particle inside a disc is barred: `barrier` plus its depth, once;
//  - a disc around the goal does not block the second leg, one around the robot does not block the first,
//    unless steps across discs are barred and the leg goes deeper into it;
//  - an arc between disc and border where the robot does not fit is no way; without a way: `barrier`;
//  - a particle outside the workspace is barred: `barrier` plus how far it is outside.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "algorithms/pso/disc_world.hpp"
#include "core/names.hpp"
#include "core/navigator.hpp"

namespace pathrace::algorithms {

/// Directions from a circle's centre to where a segment enters and leaves it, in [-pi, pi].
struct Chord {
  double entry = 0;
  double exit = 0;
};

/// Nothing when the segment misses or touches the circle, and when its middle line crosses it beyond an end.
/// Both ends outside the circle or on it.
std::optional<Chord> chord(Point from, Point to, Point centre, double radius);

/// How far the point is inside the circle; 0 when it is outside or, but for rounding, on it.
double depth_in(const Obstacle& obstacle, Point point);

/// The lesser way around; infinite when the border closes both.
double way_around(const Obstacle& obstacle, const Chord& chord);

/// What a leg across a disc costs when it is the robot's very next step.
enum class StepAcross {
  arc,     ///< the way around, as published: the robot may step across the edge of a disc
  barred,  ///< the barrier; also where it goes deeper into a disc that has run into the robot
};

/// Judges the particles of one step.
class LegJudge {
 public:
  struct Rules {
    double barrier = 0;
    StepAcross step_across = StepAcross::arc;
  };

  LegJudge(const Snapshot& snapshot, std::vector<Obstacle> obstacles, const Rules& rules);

  /// Eq. (10), over both legs. Safe for several threads at once.
  double penalty(Point particle) const;
  /// Discs tested per particle, once for each leg.
  std::uint64_t checks() const { return 2 * obstacles_.size(); }
  double barrier() const { return rules_.barrier; }

 private:
  static constexpr std::size_t block = 8;  // discs that are looked at together
  using Marks = std::array<std::uint64_t, block>;

  double outside(Point particle) const;
  double legs(const Obstacle& obstacle, Point particle) const;
  Marks met(std::size_t begin, Point particle) const;

  const Snapshot& snapshot_;
  std::vector<Obstacle> obstacles_;
  // Of the obstacles, for vectors; filled up to a whole block.
  std::vector<double> x_;
  std::vector<double> y_;
  std::vector<double> radius_;
  Rules rules_;
};

}  // namespace pathrace::algorithms

namespace pathrace {
template <>
inline constexpr auto names_of<algorithms::StepAcross> =
    std::to_array<std::pair<algorithms::StepAcross, std::string_view>>({
        {algorithms::StepAcross::arc, "arc"},
        {algorithms::StepAcross::barred, "barred"},
    });
}  // namespace pathrace
