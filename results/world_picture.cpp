#include "results/world_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "results/outcome_count.hpp"
#include "results/overlay_style.hpp"
#include "results/polyline.hpp"
#include "results/world_scene.hpp"

namespace pathrace::results {
namespace {

constexpr Colour moving_disc = {0x9a, 0xa6, 0xb8};
constexpr Colour disc_trail = {0xb8, 0xbf, 0xca};
constexpr Colour goal_trail = {0xe6, 0x9a, 0xb4};
constexpr double trail_width = 2;  // pixels, like the rest
constexpr double way_width = 3;
constexpr double particle = 1.6;
constexpr double particle_of_many = 0.8;  // the swarms of a whole run
constexpr std::size_t many_particles = 1000;
constexpr double mark_size = 9;

/// From units of the world to pixels.
struct Place {
  double left;
  double top;
  double scale;

  Point of(Point p) const {
    constexpr double far = 1e6;  // a run that was refused may lead anywhere
    return {std::clamp(left + p.x * scale, -far, far), std::clamp(top + p.y * scale, -far, far)};
  }
  std::vector<Point> of(const std::vector<Point>& points) const {
    std::vector<Point> placed;
    for (const Point point : corners_of(points)) placed.push_back(of(point));
    return placed;
  }
};

void draw_ground(Pen& pen, const PictureLayout& layout) {
  const double x = layout.left;
  const double y = layout.head;
  constexpr double edge = frame_width;
  pen.rectangle(x - edge, y - edge, layout.map_width + 2 * edge, layout.map_height + 2 * edge,
                palette.obstacle);
  pen.rectangle(x, y, layout.map_width, layout.map_height, palette.ground);
}

void draw_discs(Pen& pen, const Place& place, const World& world, const WorldScene& scene) {
  for (std::size_t i = world.walls; i < world.discs.size(); ++i) {
    const std::vector<Point>& trail = scene.disc_trails[i - world.walls];
    if (trail.size() < 2) continue;
    pen.ring(place.of(world.discs[i].centre), world.discs[i].radius * place.scale, 1, disc_trail);
  }
  for (std::size_t i = 0; i < scene.discs.size(); ++i) {
    pen.disc(place.of(scene.discs[i].centre), scene.discs[i].radius * place.scale,
             i < world.walls ? palette.obstacle : moving_disc);
  }
  for (const std::vector<Point>& trail : scene.disc_trails) {
    pen.line(place.of(trail), trail_width, palette.faint);
  }
  pen.line(place.of(scene.goal_trail), trail_width, goal_trail);
}

void draw_overlay(Pen& pen, const Place& place, const Overlay& overlay) {
  for (const OverlayCircle& circle : overlay.circles) {
    pen.ring(place.of(circle.centre), circle.radius * place.scale, overlay_line, palette.faint);
  }
  pen.line(place.of(overlay.polyline), overlay_line, palette.start);
  const double radius = overlay.points.size() > many_particles ? particle_of_many : particle;
  for (const Point point : overlay.points) {
    if (std::isfinite(point.x) && std::isfinite(point.y)) pen.disc(place.of(point), radius, shade_colour);
  }
}

void draw_robot(Pen& pen, const Place& place, const World& world, const std::vector<Point>& points,
                Colour colour) {
  pen.line(place.of(points), way_width + 3, palette.paper);
  pen.line(place.of(points), way_width, colour);
  for (const Point point : points) {
    if (std::isfinite(point.x) && std::isfinite(point.y)) pen.disc(place.of(point), way_width - 0.5, colour);
  }
  const std::vector<Point> finite = corners_of(points);
  if (finite.empty()) return;
  const double radius = std::max(world.robot_radius * place.scale, 2.0);
  pen.ring(place.of(finite.back()), radius, 2, colour);
}

std::string caption_of(const World& world, const Shown& shown) {
  std::string caption = shown.solved() ? "" : in_words(*shown.verdict) + "  \u00b7  ";
  caption += shown.answer ? fmt::format("{} steps  \u00b7  travelled {:.2f}", shown.answer->points.size() - 1,
                                        polyline_length(shown.answer->points))
                          : "before it moves";
  if (world.least_steps)
    caption += fmt::format("  \u00b7  no run takes fewer than {} steps", *world.least_steps);
  return caption + fmt::format("  \u00b7  {} \u00d7 {} units  \u00b7  {} discs", world.width, world.height,
                               world.discs.size());
}

void draw_legend(Pen& pen, const PictureLayout& layout, const World& world, Point goal) {
  const double y = layout.head + layout.map_height + 21;
  const TextStyle style{12, Weight::normal, palette.faint};
  const double left = layout.margin + 7;
  const double middle = left + 150;
  pen.start_mark(left, y, 7);
  pen.text(left + 13, y + 4, style, fmt::format("start {:.1f},{:.1f}", world.start.x, world.start.y), 130);
  pen.goal_mark(middle, y, 7);
  pen.text(middle + 13, y + 4, style, fmt::format("goal {:.1f},{:.1f}", goal.x, goal.y), 130);
}

}  // namespace

void draw_world_picture(Pen& pen, const PictureLayout& layout, const World& world, const Shown& shown) {
  const double room = layout.width - 2 * layout.margin;
  const std::vector<Point> points = shown.answer ? shown.answer->points : std::vector<Point>{};
  const WorldScene scene = scene_of(world, points);
  const Place place{layout.left, layout.head, layout.scale};
  pen.text(layout.margin, 25, {16, Weight::bold, palette.ink}, shown.title, room);
  pen.text(layout.margin, 44, {12, Weight::normal, palette.faint}, caption_of(world, shown), room);
  draw_ground(pen, layout);
  draw_discs(pen, place, world, scene);
  draw_overlay(pen, place, shown.overlay);
  draw_robot(pen, place, world, points, shown.solved() ? palette.path : palette.faint);
  const Point goal = place.of(scene.goal);
  const Point start = place.of(world.start);
  pen.goal_mark(goal.x, goal.y, mark_size);
  pen.start_mark(start.x, start.y, mark_size);
  draw_legend(pen, layout, world, scene.goal);
}

}  // namespace pathrace::results
