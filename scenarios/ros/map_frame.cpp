#include "scenarios/ros/map_frame.hpp"

#include <cmath>

namespace pathrace::scenarios {
namespace {

WorldPoint turned(WorldPoint point, double yaw) {
  if (yaw == 0) return point;
  const double cosine = std::cos(yaw);
  const double sine = std::sin(yaw);
  return {cosine * point.x - sine * point.y, sine * point.x + cosine * point.y};
}

}  // namespace

// Row 0 is the top, and a cell's centre has the cell's coordinates, so the lower left corner of the map is at
// -0.5, height - 0.5.
Point MapFrame::point_of(WorldPoint place) const {
  const WorldPoint local = turned({place.x - origin.x, place.y - origin.y}, -yaw);
  return {local.x / resolution - 0.5, height - 0.5 - local.y / resolution};
}

WorldPoint MapFrame::place_of(Point point) const {
  const WorldPoint local = turned({(point.x + 0.5) * resolution, (height - 0.5 - point.y) * resolution}, yaw);
  return {local.x + origin.x, local.y + origin.y};
}

std::optional<Cell> MapFrame::cell_at(WorldPoint place) const {
  const WorldPoint local = turned({place.x - origin.x, place.y - origin.y}, -yaw);
  const double column = std::floor(local.x / resolution);
  const double row = std::floor(local.y / resolution);
  const bool on_map = column >= 0 && row >= 0 && column < width && row < height;  // false for not a number
  if (!on_map) return std::nullopt;
  return Cell{static_cast<int>(column), height - 1 - static_cast<int>(row)};
}

}  // namespace pathrace::scenarios
