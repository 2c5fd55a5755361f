// Where a grid lies in the world.
//
// The origin is the world's coordinates, in metres, of the lower left corner of the lower left cell, turned
// counter-clockwise by yaw; row 0 of the grid is the top. So the lower left cell is (0, height - 1).
#pragma once

#include <optional>

#include "core/cell.hpp"

namespace pathrace::scenarios {

/// A place in the world, in metres.
struct WorldPoint {
  double x = 0;
  double y = 0;
};

struct MapFrame {
  int width = 1;          ///< columns
  int height = 1;         ///< rows
  double resolution = 1;  ///< metres per cell edge, above 0
  WorldPoint origin;
  double yaw = 0;  ///< radians

  /// The same place in cell edges, on the map or off it.
  Point point_of(WorldPoint place) const;
  WorldPoint place_of(Point point) const;
  /// The cell that holds the place; nothing when it is off the map.
  std::optional<Cell> cell_at(WorldPoint place) const;
  /// A length in cell edges, in metres.
  double metres(double edges) const { return edges * resolution; }
};

}  // namespace pathrace::scenarios
