#include "algorithms/pso/waypoint_birth.hpp"

#include <algorithm>

namespace pathrace::algorithms {

WaypointNursery::WaypointNursery(const OccupancyGrid& grid, Cell start, Cell goal, Birth birth,
                                 double scatter)
    : right_(grid.width() - 1),
      bottom_(grid.height() - 1),
      start_(centre(start)),
      goal_(centre(goal)),
      birth_(birth),
      scatter_(scatter) {}

SwarmBox WaypointNursery::box(std::size_t waypoints, double v_max) const {
  SwarmBox box;
  for (const double high : {right_, bottom_}) {
    box.low.insert(box.low.end(), waypoints, 0);
    box.high.insert(box.high.end(), waypoints, high);
    box.max_speed.insert(box.max_speed.end(), waypoints, v_max * high / 2);
  }
  return box;
}

double WaypointNursery::birthplace(double from, double to, double share, double high, Stream& stream) const {
  const double draw = stream.uniform();
  if (birth_ == Birth::uniform) return high * draw;
  return std::clamp(from + share * (to - from) + scatter_ * (2 * draw - 1), 0.0, high);
}

void WaypointNursery::place(Swarm& swarm, std::size_t i, Stream stream) const {
  const std::span<double> position = swarm.position(i);
  const std::span<double> velocity = swarm.velocity(i);
  const std::size_t waypoints = position.size() / 2;
  for (std::size_t k = 0; k < waypoints; ++k) {
    const double share = static_cast<double>(k + 1) / static_cast<double>(waypoints + 1);
    position[k] = birthplace(start_.x, goal_.x, share, right_, stream);
    position[waypoints + k] = birthplace(start_.y, goal_.y, share, bottom_, stream);
  }
  for (std::size_t d = 0; d < velocity.size(); ++d) {
    velocity[d] = swarm.box().max_speed[d] * (2 * stream.uniform() - 1);
  }
}

}  // namespace pathrace::algorithms
