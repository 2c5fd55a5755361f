#include "baselines/navigators/steer.hpp"

#include <array>
#include <utility>

#include "baselines/navigators/room.hpp"

namespace pathrace::baselines {
namespace {

// A path's points in the snapshot's units; its end is the goal itself.
std::vector<Point> way_of(const Path& path, const DiscMap& map, Point goal) {
  std::vector<Point> way;
  way.reserve(path.points.size());
  for (const Point point : path.points) way.push_back(map.place_of(point));
  way.back() = goal;
  return way;
}

bool is_straight(Point a, Point b, Point c) {
  return (b.x - a.x) * (c.y - b.y) == (b.y - a.y) * (c.x - b.x);
}

double length_of(const std::vector<Point>& way) {
  double length = 0;
  for (std::size_t i = 1; i < way.size(); ++i) length += straight_line(way[i - 1], way[i]);
  return length;
}

// Collinear neighbours are looked at as one segment.
bool is_clear_way(const std::vector<Point>& way, const Snapshot& snapshot, Meter& meter) {
  for (std::size_t from = 0, to = 1; to < way.size(); ++to) {
    if (to + 1 < way.size() && is_straight(way[from], way[to], way[to + 1])) continue;
    if (!afford(meter, snapshot.discs.size()) || !is_clear(snapshot, way[from], way[to])) return false;
    from = to;
  }
  return true;
}

// Where a disc is nearer than half a step: to the roomiest of nine places in reach, the present one included.
Point step_aside(const Snapshot& snapshot, Meter& meter) {
  Point best = snapshot.robot;
  double most = room_at(snapshot, best);
  if (!afford(meter, snapshot.discs.size() * 17) || most >= snapshot.robot_step / 2) return best;
  for (const Point direction :
       {Point{1, 0}, {0.6, 0.8}, {0, 1}, {-0.8, 0.6}, {-1, 0}, {-0.6, -0.8}, {0, -1}, {0.8, -0.6}}) {
    const Point place = kept_inside(snapshot, {snapshot.robot.x + snapshot.robot_step * direction.x,
                                               snapshot.robot.y + snapshot.robot_step * direction.y});
    const double room = room_at(snapshot, place);
    if (room <= most || !is_free_way(snapshot, place)) continue;
    most = room;
    best = place;
  }
  return best;
}

}  // namespace

Point Steering::next(const Snapshot& snapshot, Meter& meter, const PlanOnMap& plan) {
  std::optional<Course> course = kept(snapshot, meter);
  std::optional<Course> fresh = planned(snapshot, meter, plan);
  if (fresh && (!course || fresh->length < course->length)) course = std::move(fresh);
  if (!course) {
    way_.clear();
    return step_aside(snapshot, meter);
  }
  way_ = std::move(course->way);
  return course->step;
}

// Towards the farthest point in sight; else the first step that is free at all.
std::optional<Steering::Course> Steering::course_along(std::vector<Point> way, const Snapshot& snapshot,
                                                       Meter& meter) {
  for (const bool whole : {true, false}) {
    for (std::size_t left = way.size(); left > 0; --left) {
      if (!afford(meter, snapshot.discs.size())) return std::nullopt;
      const Point point = way[left - 1];
      const Point step = kept_inside(snapshot, towards(snapshot.robot, point, snapshot.robot_step));
      if (step == snapshot.robot || !is_free_way(snapshot, whole ? point : step)) continue;
      way.erase(way.begin(), way.begin() + static_cast<std::ptrdiff_t>(left - 1));
      const double length = straight_line(snapshot.robot, point) + length_of(way);
      return Course{std::move(way), step, length};
    }
  }
  return std::nullopt;
}

std::optional<Steering::Course> Steering::kept(const Snapshot& snapshot, Meter& meter) const {
  if (way_.empty()) return std::nullopt;
  std::vector<Point> way = way_;
  way.back() = snapshot.goal;
  if (!is_clear_way(way, snapshot, meter)) return std::nullopt;
  return course_along(std::move(way), snapshot, meter);
}

std::optional<Steering::Course> Steering::planned(const Snapshot& snapshot, Meter& meter,
                                                  const PlanOnMap& plan) const {
  const std::array<double, 2> margins = {margin_, 0.0};
  for (std::size_t attempt = 0; attempt < margins.size(); ++attempt) {
    if (!afford(meter, snapshot.discs.size())) continue;
    const DiscMap map(snapshot, resolution_, margins[attempt]);
    const Answer answer = plan(map, attempt);
    if (!answer) continue;
    std::optional<Course> course = course_along(way_of(*answer, map, snapshot.goal), snapshot, meter);
    if (course) return course;
  }
  return std::nullopt;
}

}  // namespace pathrace::baselines
