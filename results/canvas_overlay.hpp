// A planner's overlay on a canvas.
#pragma once

#include "core/grid.hpp"
#include "core/overlay.hpp"
#include "results/raster.hpp"

namespace pathrace::results {

/// Where the map lies on the canvas, in pixels; a cell has `scale` of them.
struct MapPlace {
  int left = 0;
  int top = 0;
  double scale = 1;
};

/// The field, over free cells alone. Maps below one pixel per cell have no field.
void paint_field(Canvas& canvas, const MapPlace& place, const Overlay& overlay, const OccupancyGrid& grid);
/// Circles and line.
void paint_shapes(Canvas& canvas, const MapPlace& place, const Overlay& overlay);

}  // namespace pathrace::results
