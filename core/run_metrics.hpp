// What is measured on a run through a dynamic world, whoever steered it.
#pragma once

#include <cstdint>
#include <optional>

namespace pathrace {

struct RunMetrics {
  std::uint64_t steps = 0;
  double travelled = 0;                 ///< in units of the world
  std::uint64_t collisions = 0;         ///< (step, disc) pairs in which the robot drove into a disc
  std::uint64_t struck = 0;             ///< (step, disc) pairs in which a disc drove into the robot
  std::uint64_t oscillations = 0;       ///< steps that came back to where the robot had been and left
  std::optional<double> min_clearance;  ///< least gap between robot and discs; negative: they overlapped
  std::uint64_t world_hash = 0;         ///< of the world as the referee saw it move

  friend bool operator==(const RunMetrics&, const RunMetrics&) = default;
};

}  // namespace pathrace
