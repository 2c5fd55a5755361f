#include "scenarios/discs/worlds.hpp"

#include <fmt/format.h>

#include <optional>

#include "core/error.hpp"
#include "core/stream.hpp"

namespace pathrace::scenarios {
namespace {

constexpr int drawings = 200;     // of a whole world
constexpr int throws_each = 500;  // of one disc, or of both ends
constexpr std::size_t way_points = 4;

World givens(const DiscsSettings& settings) {
  World world;
  world.width = settings.size;
  world.height = settings.size;
  world.robot_radius = settings.robot_radius;
  world.robot_step = settings.v_robot;
  world.arrival = settings.arrival * settings.v_robot;
  world.goal_law = settings.goal;
  world.goal_step = settings.v_goal * settings.v_robot;
  world.goal_chance = settings.p_goal;
  world.disc_step = settings.v_obs * settings.v_robot;
  world.disc_chance = settings.p_obs;
  world.max_steps = static_cast<std::uint64_t>(settings.max_steps);
  return world;
}

Point draw_point(double size, double border, Stream& stream) {
  const double x = border + (size - 2 * border) * stream.uniform();
  const double y = border + (size - 2 * border) * stream.uniform();
  return {x, y};
}

bool clear(const World& world, Point centre, double radius) {
  for (const Disc& disc : world.discs) {
    if (straight_line(centre, disc.centre) < radius + disc.radius) return false;
  }
  return true;
}

// Two points far apart, when the kind has none of its own.
bool place_ends(DiscsSketch& sketch, Stream& stream) {
  World& world = sketch.world;
  if (sketch.placed) return true;
  const double border = world.robot_radius + 0.02 * world.width;
  for (int i = 0; i < throws_each; ++i) {
    world.start = draw_point(world.width, border, stream);
    world.goal = draw_point(world.width, border, stream);
    if (straight_line(world.start, world.goal) >= 0.6 * world.width) return true;
  }
  return false;
}

// Clear of both ends by the robot's radius and one step of the robot, so that no run begins in a corner.
bool place_disc(const DiscsSettings& settings, World& world, Stream& stream) {
  const double radius = settings.r_min + (settings.r_max - settings.r_min) * stream.uniform();
  const double from_ends = radius + world.robot_radius + world.robot_step;
  for (int i = 0; i < throws_each; ++i) {
    const Point centre = draw_point(world.width, radius, stream);
    if (straight_line(centre, world.start) < from_ends || straight_line(centre, world.goal) < from_ends)
      continue;
    if (!clear(world, centre, radius)) continue;
    world.discs.push_back({centre, radius});
    return true;
  }
  return false;
}

bool place_way_points(World& world, Stream& stream) {
  if (world.goal_law != GoalLaw::way_points) return true;
  for (int i = 0; i < throws_each && world.way_points.size() < way_points; ++i) {
    const Point point = draw_point(world.width, world.robot_radius, stream);
    if (clear(world, point, world.robot_radius)) world.way_points.push_back(point);
  }
  return world.way_points.size() == way_points;
}

// In a corridor loose discs start between the walls, wherever else there is room.
bool between_walls(const DiscsKind& kind, const DiscsSettings& settings, const World& world) {
  if (kind.name != "corridor") return true;
  const Disc& last = world.discs.back();
  const double off = last.centre.y - world.height / 2;
  return off + last.radius <= settings.lane / 2 && last.radius - off <= settings.lane / 2;
}

bool place_discs(const DiscsKind& kind, const DiscsSettings& settings, World& world, Stream& stream) {
  const std::size_t wanted = world.walls + static_cast<std::size_t>(settings.discs);
  for (int i = 0; i < throws_each * 4 && world.discs.size() < wanted; ++i) {
    if (!place_disc(settings, world, stream)) return false;
    if (!between_walls(kind, settings, world)) world.discs.pop_back();
  }
  return world.discs.size() == wanted;
}

std::optional<World> drawn(const DiscsKind& kind, const DiscsSettings& settings, Stream stream) {
  DiscsSketch sketch{givens(settings)};
  kind.draw(settings, stream, sketch);
  const bool complete = place_ends(sketch, stream) && place_discs(kind, settings, sketch.world, stream) &&
                        place_way_points(sketch.world, stream);
  if (!complete) return std::nullopt;
  return std::move(sketch.world);
}

}  // namespace

std::shared_ptr<const World> draw_world(const std::string& id, const DiscsKind& kind,
                                        const DiscsSettings& settings) {
  const Stream stream = Stream(0).fork("scenario").fork(id);
  for (std::uint64_t i = 0; i < drawings; ++i) {
    std::optional<World> world = drawn(kind, settings, stream.fork(i));
    if (!world) continue;
    world->motion = stream.fork("motion").place();
    return settled(std::move(*world), id);
  }
  throw InvalidScenario(fmt::format("{}: {} drawings left no room for {} discs of radius {} to {}", id,
                                    drawings, settings.discs, settings.r_min, settings.r_max));
}

}  // namespace pathrace::scenarios
