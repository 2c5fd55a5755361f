#include "baselines/navigators/room.hpp"

#include <algorithm>

#include "core/world.hpp"

namespace pathrace::baselines {
namespace {

constexpr double spare = 1e-7;  // units; keeps rounding out of touching

// Least distance of a point to the segment from a to b.
double segment_distance(Point a, Point b, Point p) {
  const Point d{b.x - a.x, b.y - a.y};
  const double squared = d.x * d.x + d.y * d.y;
  if (squared == 0) return straight_line(a, p);
  const double t = std::clamp(((p.x - a.x) * d.x + (p.y - a.y) * d.y) / squared, 0.0, 1.0);
  return straight_line({a.x + t * d.x, a.y + t * d.y}, p);
}

}  // namespace

Point towards(Point from, Point to, double length) {
  const double apart = straight_line(from, to);
  if (apart <= length) return to;
  const double share = length / apart;
  return {from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)};
}

bool is_free_way(const Snapshot& snapshot, Point to) {
  for (const Disc& disc : snapshot.discs) {
    const double least = segment_distance(snapshot.robot, to, disc.centre);
    const bool overlaps = least < disc.radius + snapshot.robot_radius + spare;
    if (overlaps && least < straight_line(snapshot.robot, disc.centre)) return false;
  }
  return true;
}

bool is_clear(const Snapshot& snapshot, Point from, Point to) {
  for (const Disc& disc : snapshot.discs) {
    if (segment_distance(from, to, disc.centre) < disc.radius + snapshot.robot_radius + spare) return false;
  }
  return true;
}

double room_at(const Snapshot& snapshot, Point robot) {
  double room = snapshot.width;
  for (const Disc& disc : snapshot.discs) {
    room = std::min(room, straight_line(robot, disc.centre) - disc.radius - snapshot.robot_radius);
  }
  return room;
}

Point kept_inside(const Snapshot& snapshot, Point point) {
  const double radius = snapshot.robot_radius;
  return {std::clamp(point.x, radius, std::max(radius, snapshot.width - radius)),
          std::clamp(point.y, radius, std::max(radius, snapshot.height - radius))};
}

bool afford(Meter& meter, std::uint64_t checks) {
  const std::uint64_t left = meter.checks_left();
  meter.spend_checks(std::min(checks, left));
  return checks <= left;
}

}  // namespace pathrace::baselines
