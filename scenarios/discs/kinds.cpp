// The kinds of dynamic worlds: open, dense, ring, c-trap, corridor, chase.
//
// Rings are twelve walls on a circle of a fifth of the side, at multiples of 30 degrees, turned by a drawn
// direction: their cosines are 0, 1/2, sqrt(3)/2 and 1, so that no libm call is needed.
#include <cmath>

#include "core/world_motion.hpp"
#include "scenarios/discs/settings.hpp"

namespace pathrace::scenarios {
namespace {

constexpr std::size_t ring_discs = 12;

// Unit vectors at 0, 30, ..., 330 degrees.
std::array<Point, ring_discs> clock_face() {
  const double half_root_3 = std::sqrt(0.75);
  const std::array<Point, 3> quarter = {Point{1, 0}, {half_root_3, 0.5}, {0.5, half_root_3}};
  std::array<Point, ring_discs> all;
  for (std::size_t i = 0; i < ring_discs; ++i) {
    Point p = quarter[i % 3];
    for (std::size_t turn = 0; turn < i / 3; ++turn) p = {-p.y, p.x};
    all[i] = p;
  }
  return all;
}

struct Ring {
  Point centre;
  double radius;
  double disc;  // radius of a wall
};

// Chord of 30 degrees: 2 sin 15 = sqrt(2 - sqrt(3)).
Ring ring_of(const DiscsSettings& settings, Point centre) {
  const double radius = 0.2 * settings.size;
  const double chord = radius * std::sqrt(2 - std::sqrt(3.0));
  return {centre, radius, (chord - settings.gap) / 2};
}

void add_wall(World& world, Point centre, double radius) {
  world.discs.push_back({centre, radius});
  world.walls = world.discs.size();
}

double jitter(const DiscsSettings& settings, Stream& stream) {
  return 0.1 * settings.size * (stream.uniform() - 0.5);
}

void across(const DiscsSettings& settings, double start_y, double goal_y, DiscsSketch& sketch) {
  const double border = std::max(settings.robot_radius, 0.06 * settings.size);
  sketch.world.start = {border, start_y};
  sketch.world.goal = {settings.size - border, goal_y};
  sketch.placed = true;
}

void draw_open(const DiscsSettings&, Stream&, DiscsSketch&) {}

void draw_ring(const DiscsSettings& settings, Stream& stream, DiscsSketch& sketch) {
  const double middle = settings.size / 2.0;
  const Ring ring = ring_of(settings, {middle, middle});
  const Point turn = draw_direction(stream);
  for (const Point p : clock_face()) {
    add_wall(sketch.world,
             {ring.centre.x + ring.radius * (turn.x * p.x - turn.y * p.y),
              ring.centre.y + ring.radius * (turn.y * p.x + turn.x * p.y)},
             ring.disc);
  }
  const double start_y = middle + jitter(settings, stream);
  const double goal_y = middle + jitter(settings, stream);
  across(settings, start_y, goal_y, sketch);
  if (settings.inside == Inside::robot) sketch.world.start = ring.centre;
  if (settings.inside == Inside::goal) sketch.world.goal = ring.centre;
}

// The ring without the three walls that face the start.
void draw_c_trap(const DiscsSettings& settings, Stream& stream, DiscsSketch& sketch) {
  const double middle = settings.size / 2.0;
  const Ring ring = ring_of(settings, {middle, middle + jitter(settings, stream)});
  const std::array<Point, ring_discs> face = clock_face();
  for (std::size_t i = 0; i < ring_discs; ++i) {
    if (i >= 5 && i <= 7) continue;
    add_wall(sketch.world, {ring.centre.x + ring.radius * face[i].x, ring.centre.y + ring.radius * face[i].y},
             ring.disc);
  }
  const double near = 0.1 * jitter(settings, stream);  // almost symmetric: both ways round are as long
  across(settings, ring.centre.y + near, ring.centre.y, sketch);
}

void draw_corridor(const DiscsSettings& settings, Stream& stream, DiscsSketch& sketch) {
  const double radius = 0.05 * settings.size;
  const double middle = settings.size / 2.0;
  for (int i = 0; i < 10; ++i) {
    const double x = radius * (2 * i + 1);
    add_wall(sketch.world, {x, middle - settings.lane / 2 - radius}, radius);
    add_wall(sketch.world, {x, middle + settings.lane / 2 + radius}, radius);
  }
  const double room = std::max(0.0, settings.lane / 2 - 2 * settings.robot_radius);
  const double start_y = middle + room * (2 * stream.uniform() - 1);
  const double goal_y = middle + room * (2 * stream.uniform() - 1);
  across(settings, start_y, goal_y, sketch);
}

}  // namespace

const std::vector<DiscsKind>& discs_kinds() {
  static const std::vector<DiscsKind> kinds = {
      {"open", "ten moving discs, a wandering goal", {}, {"goal"}, draw_open},
      {"dense", "thirty smaller ones", {{"discs", "30"}, {"r_max", "6"}}, {"goal"}, draw_open},
      {"ring",
       "a closed ring of touching discs",
       {{"discs", "0"}, {"p_goal", "0"}},
       {"goal", "gap", "inside"},
       draw_ring},
      {"c-trap",
       "a cup of discs that opens to the robot, its gaps too wide to be adjacent",
       {{"discs", "0"}, {"p_goal", "0"}, {"gap", "3"}},
       {"goal", "gap"},
       draw_c_trap},
      {"corridor",
       "moving discs between two walls of touching ones",
       {{"discs", "6"}, {"r_min", "2"}, {"r_max", "4"}},
       {"goal", "lane"},
       draw_corridor},
      {"chase", "moving discs, and a goal that flees", {{"goal", "flee"}, {"p_goal", "1"}}, {}, draw_open},
  };
  return kinds;
}

}  // namespace pathrace::scenarios
