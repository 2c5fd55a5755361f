// How a particle stands for the robot's next step: a direction, at a fixed distance R from the robot.
//
// `projected`: two coordinates, the step itself; after each move it is stretched or shrunk to the length R.
// `angle`: one coordinate, the angle alpha of eq. (6) and (7) of Nasrollahy and Javadi, in [0, 2 pi].
#pragma once

#include <array>
#include <span>
#include <string_view>
#include <utility>

#include "algorithms/pso/swarm.hpp"
#include "core/cell.hpp"
#include "core/names.hpp"

namespace pathrace::algorithms {

enum class Heading { projected, angle };

class Compass {
 public:
  /// R > 0.
  Compass(Heading heading, double radius) : heading_(heading), radius_(radius) {}

  double radius() const { return radius_; }
  /// Bounds of a particle when the longest step is `robot_step`; `v_max` counts in half ranges.
  SwarmBox box(double robot_step, double v_max) const;
  /// A uniform direction, and a velocity of the greatest size in another one.
  void place(std::span<double> position, std::span<double> velocity, const SwarmBox& box,
             Stream stream) const;
  /// Gives the step its length R; a step of no length gets a new direction, from a fork of the stream.
  void project(std::span<double> position, const Stream& stream) const;
  /// The step itself.
  Point step(std::span<const double> position) const;

 private:
  Heading heading_;
  double radius_;
};

}  // namespace pathrace::algorithms

namespace pathrace {
template <>
inline constexpr auto names_of<algorithms::Heading> =
    std::to_array<std::pair<algorithms::Heading, std::string_view>>({
        {algorithms::Heading::projected, "projected"},
        {algorithms::Heading::angle, "angle"},
    });
}  // namespace pathrace
