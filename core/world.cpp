#include "core/world.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/error.hpp"
#include "core/pursuit_bound.hpp"
#include "core/world_motion.hpp"

namespace pathrace {
namespace {

constexpr double touching = 1e-9;  // discs that touch may overlap by rounding, in units

[[noreturn]] void refuse(std::string_view id, const std::string& what) {
  throw InvalidScenario(fmt::format("{}: {}", id, what));
}

void require_numbers(const World& world, std::string_view id) {
  for (const double length : {world.width, world.height, world.robot_step}) {
    if (!(std::isfinite(length) && length > 0)) {
      refuse(id, fmt::format("width, height and V_robot must be positive, got {}", length));
    }
  }
  for (const double length : {world.robot_radius, world.arrival, world.goal_step, world.disc_step}) {
    if (!(std::isfinite(length) && length >= 0)) {
      refuse(id, fmt::format("lengths and speeds must not be negative, got {}", length));
    }
  }
  for (const double chance : {world.goal_chance, world.disc_chance}) {
    if (!(chance >= 0 && chance <= 1)) refuse(id, fmt::format("a chance must be in [0, 1], got {}", chance));
  }
  if (world.goal_step >= world.robot_step) {
    refuse(id, fmt::format("V_goal must be below V_robot, got {} and {}", world.goal_step, world.robot_step));
  }
}

void require_room(const World& world, std::string_view id, std::string_view what, Point point,
                  double radius) {
  const bool inside = point.x >= radius && point.x <= world.width - radius && point.y >= radius &&
                      point.y <= world.height - radius;
  if (!inside) refuse(id, fmt::format("{} {},{} is too near to the border", what, point.x, point.y));
}

void require_apart(const World& world, std::string_view id) {
  for (std::size_t i = 0; i < world.discs.size(); ++i) {
    const Disc& disc = world.discs[i];
    if (!(std::isfinite(disc.radius) && disc.radius > 0)) {
      refuse(id, fmt::format("disc {} has the radius {}", i, disc.radius));
    }
    require_room(world, id, fmt::format("disc {} at", i), disc.centre, disc.radius - touching);
    const double reach = disc.radius + world.robot_radius - touching;
    if (straight_line(disc.centre, world.start) < reach)
      refuse(id, fmt::format("disc {} covers the start", i));
    if (straight_line(disc.centre, world.goal) < reach) refuse(id, fmt::format("disc {} covers the goal", i));
    for (std::size_t j = 0; j < i; ++j) {
      if (straight_line(disc.centre, world.discs[j].centre) <
          disc.radius + world.discs[j].radius - touching) {
        refuse(id, fmt::format("the discs {} and {} overlap", j, i));
      }
    }
  }
}

}  // namespace

double straight_line(Point a, Point b) {
  const double dx = a.x - b.x;
  const double dy = a.y - b.y;
  return std::sqrt(dx * dx + dy * dy);
}

std::uint64_t world_hash(const World& world) {
  return WorldMotion(world).hash_to_the_end();
}

std::shared_ptr<const World> settled(World world, std::string_view id) {
  require_numbers(world, id);
  require_room(world, id, "start", world.start, world.robot_radius);
  require_room(world, id, "goal", world.goal, world.robot_radius);
  if (world.walls > world.discs.size()) refuse(id, "more walls than discs");
  require_apart(world, id);
  world.hash = world_hash(world);
  world.least_steps = least_steps(world);
  return std::make_shared<const World>(std::move(world));
}

}  // namespace pathrace
