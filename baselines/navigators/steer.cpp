#include "baselines/navigators/steer.hpp"

#include <array>
#include <optional>
#include <vector>

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

// The step towards the farthest point in sight; else the first step that is free at all.
std::optional<Point> step_along(const std::vector<Point>& way, const Snapshot& snapshot, Meter& meter) {
  for (const bool whole : {true, false}) {
    for (std::size_t left = way.size(); left > 0; --left) {
      if (!afford(meter, snapshot.discs.size())) return std::nullopt;
      const Point point = way[left - 1];
      const Point step = kept_inside(snapshot, towards(snapshot.robot, point, snapshot.robot_step));
      if (step != snapshot.robot && is_free_way(snapshot, whole ? point : step)) return step;
    }
  }
  return std::nullopt;
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

Point steer(const Snapshot& snapshot, double resolution, double margin, Meter& meter, const PlanOnMap& plan) {
  const std::array<double, 2> margins = {margin, 0.0};
  for (std::size_t attempt = 0; attempt < margins.size(); ++attempt) {
    if (!afford(meter, snapshot.discs.size())) continue;
    const DiscMap map(snapshot, resolution, margins[attempt]);
    const Answer answer = plan(map, attempt);
    if (!answer) continue;
    const std::vector<Point> way = way_of(*answer, map, snapshot.goal);
    if (const std::optional<Point> step = step_along(way, snapshot, meter)) return *step;
  }
  return step_aside(snapshot, meter);
}

}  // namespace pathrace::baselines
