#include "core/world_motion.hpp"

#include <cmath>

namespace pathrace {
namespace {

constexpr int directions_tried = 8;

Point moved(Point from, Point direction, double length) {
  return {from.x + length * direction.x, from.y + length * direction.y};
}

bool within(const World& world, Point centre, double radius) {
  return centre.x >= radius && centre.x <= world.width - radius && centre.y >= radius &&
         centre.y <= world.height - radius;
}

void add(Hasher& hasher, Point point) {
  hasher.add(point.x).add(point.y);
}

void add_givens(Hasher& hasher, const World& world) {
  hasher.add(world.width).add(world.height);
  add(hasher, world.start);
  hasher.add(world.robot_radius).add(world.robot_step).add(world.arrival);
  add(hasher, world.goal);
  hasher.add(name(world.goal_law)).add(world.goal_step).add(world.goal_chance);
  hasher.add(std::uint64_t{world.way_points.size()});
  for (const Point point : world.way_points) add(hasher, point);
  hasher.add(std::uint64_t{world.discs.size()}).add(std::uint64_t{world.walls});
  for (const Disc& disc : world.discs) {
    add(hasher, disc.centre);
    hasher.add(disc.radius);
  }
  hasher.add(world.disc_step).add(world.disc_chance).add(world.max_steps).add(world.motion);
}

}  // namespace

Point draw_direction(Stream& stream) {
  constexpr double too_short = 1e-4;  // squared: its direction would be coarse
  while (true) {
    const double x = 2 * stream.uniform() - 1;
    const double y = 2 * stream.uniform() - 1;
    const double squared = x * x + y * y;
    if (squared > 1 || squared < too_short) continue;
    const double length = std::sqrt(squared);
    return {x / length, y / length};
  }
}

WorldMotion::WorldMotion(const World& world)
    : world_(world), stream_(world.motion), discs_(world.discs), goal_(world.goal) {
  add_givens(hasher_, world);
}

void WorldMotion::advance(Point robot) {
  const Stream stream = stream_.fork(step_++);
  for (std::size_t i = world_.walls; i < discs_.size(); ++i) move_disc(i, stream.fork(i));
  move_goal(robot, stream.fork("goal"));
  for (const Disc& disc : discs_) add(hasher_, disc.centre);
  if (world_.goal_law != GoalLaw::flee) add(hasher_, goal_);
}

std::uint64_t WorldMotion::hash_to_the_end() {
  while (step_ < world_.max_steps) advance(goal_);
  return hasher_.value();
}

void WorldMotion::move_disc(std::size_t index, Stream stream) {
  if (!stream.chance(world_.disc_chance)) return;
  for (int i = 0; i < directions_tried; ++i) {
    const Point centre = moved(discs_[index].centre, draw_direction(stream), world_.disc_step);
    if (!fits(index, centre)) continue;
    discs_[index].centre = centre;
    return;
  }
}

bool WorldMotion::fits(std::size_t index, Point centre) const {
  const double radius = discs_[index].radius;
  if (!within(world_, centre, radius)) return false;
  if (world_.goal_law != GoalLaw::flee && straight_line(centre, goal_) < radius + world_.robot_radius)
    return false;
  for (std::size_t i = 0; i < discs_.size(); ++i) {
    if (i != index && straight_line(centre, discs_[i].centre) < radius + discs_[i].radius) return false;
  }
  return true;
}

void WorldMotion::move_goal(Point robot, Stream stream) {
  if (!stream.chance(world_.goal_chance)) return;
  switch (world_.goal_law) {
    case GoalLaw::random: return wander(stream);
    case GoalLaw::way_points: return follow_way_points();
    case GoalLaw::flee: return flee(robot);
  }
}

bool WorldMotion::goal_fits(Point goal) const {
  if (!within(world_, goal, world_.robot_radius)) return false;
  for (const Disc& disc : discs_) {
    if (straight_line(goal, disc.centre) < disc.radius + world_.robot_radius) return false;
  }
  return true;
}

bool WorldMotion::try_goal(Point goal) {
  if (!goal_fits(goal)) return false;
  goal_ = goal;
  return true;
}

void WorldMotion::wander(Stream& stream) {
  for (int i = 0; i < directions_tried; ++i) {
    if (try_goal(moved(goal_, draw_direction(stream), world_.goal_step))) return;
  }
}

void WorldMotion::follow_way_points() {
  if (world_.way_points.empty()) return;
  const Point target = world_.way_points[way_point_];
  const double left = straight_line(goal_, target);
  const bool reaches = left <= world_.goal_step;
  const Point next =
      reaches ? target
              : moved(goal_, {(target.x - goal_.x) / left, (target.y - goal_.y) / left}, world_.goal_step);
  if (!try_goal(next) || reaches) way_point_ = (way_point_ + 1) % world_.way_points.size();
}

void WorldMotion::flee(Point robot) {
  const double apart = straight_line(robot, goal_);
  if (apart == 0) return;
  const Point away{(goal_.x - robot.x) / apart, (goal_.y - robot.y) / apart};
  const Point side{-away.y, away.x};
  const double half = std::sqrt(0.5);
  const Point choices[] = {away,
                           {half * (away.x + side.x), half * (away.y + side.y)},
                           {half * (away.x - side.x), half * (away.y - side.y)},
                           side,
                           {-side.x, -side.y}};
  for (const Point direction : choices) {
    if (try_goal(moved(goal_, direction, world_.goal_step))) return;
  }
}

}  // namespace pathrace
