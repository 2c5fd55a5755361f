// A sketch: what a planner thought about a map before it searched, for pictures.
#pragma once

#include <vector>

#include "core/cell.hpp"

namespace pathrace {

struct SketchCircle {
  Point centre;
  double radius = 0;  ///< in cell edges

  friend bool operator==(const SketchCircle&, const SketchCircle&) = default;
};

/// All parts may be empty.
struct Sketch {
  std::vector<SketchCircle> circles;
  std::vector<Point> polyline;
  std::vector<double> field;  ///< one value per cell, row by row, width * height of the map
};

}  // namespace pathrace
