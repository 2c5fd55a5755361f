// The ground and the obstacles of a map on a canvas.
#pragma once

#include "core/grid.hpp"
#include "results/raster.hpp"

namespace pathrace::results {

/// Paints the map with its upper left corner at pixel (left, top). With `scale` >= 1 pixels per cell, a whole
/// number, cells are sharp; below, a pixel takes the obstacles' colour by the share of it that is blocked.
void paint_ground(Canvas& canvas, int left, int top, double scale, const OccupancyGrid& grid);

}  // namespace pathrace::results
