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

std::optional<Cell> MapFrame::cell_at(WorldPoint point) const {
  const WorldPoint local = turned({point.x - origin.x, point.y - origin.y}, -yaw);
  const double column = std::floor(local.x / resolution);
  const double row = std::floor(local.y / resolution);
  const bool on_map = column >= 0 && row >= 0 && column < width && row < height;  // false for not a number
  if (!on_map) return std::nullopt;
  return Cell{static_cast<int>(column), height - 1 - static_cast<int>(row)};
}

WorldPoint MapFrame::centre_of(Cell cell) const {
  const WorldPoint local =
      turned({(cell.x + 0.5) * resolution, (height - 1 - cell.y + 0.5) * resolution}, yaw);
  return {local.x + origin.x, local.y + origin.y};
}

}  // namespace pathrace::scenarios
