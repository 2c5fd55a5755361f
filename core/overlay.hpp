// An overlay: what a planner or a navigator thinks, for pictures. No result depends on it.
#pragma once

#include <vector>

#include "core/cell.hpp"

namespace pathrace {

struct OverlayCircle {
  Point centre;
  double radius = 0;  ///< in cell edges

  friend bool operator==(const OverlayCircle&, const OverlayCircle&) = default;
};

/// All parts may be empty.
struct Overlay {
  std::vector<OverlayCircle> circles;
  std::vector<Point> polyline;
  std::vector<Point> points;  ///< scattered ones, such as the particles of a swarm
  std::vector<double> field;  ///< one value per cell, row by row, width * height of the map
};

}  // namespace pathrace
