#include "core/pursuit_bound.hpp"

#include "core/world_motion.hpp"

namespace pathrace {

std::optional<std::uint64_t> least_steps(const World& world) {
  const double rounding = 1e-9 * (world.width + world.height);  // the bound may be low, never high
  WorldMotion motion(world);
  for (std::uint64_t k = 0; k <= world.max_steps; ++k) {
    const Point goal = world.goal_law == GoalLaw::flee ? world.goal : motion.goal();
    const double reach = static_cast<double>(k) * world.robot_step + world.arrival + rounding;
    if (straight_line(world.start, goal) <= reach) return k;
    if (world.goal_law != GoalLaw::flee) motion.advance(world.start);
  }
  return std::nullopt;
}

}  // namespace pathrace
