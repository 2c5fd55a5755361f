// A planner's overlay as SVG elements, in cell units: cell (0, 0) covers -0.5..0.5.
#pragma once

#include <ostream>

#include "core/grid.hpp"
#include "core/overlay.hpp"
#include "results/picture_style.hpp"

namespace pathrace::results {

/// The field, below everything else. Expects one value per cell of the map, or none.
void write_svg_field(std::ostream& out, const Overlay& overlay, const OccupancyGrid& grid);
/// Circles and line, above the obstacles.
void write_svg_shapes(std::ostream& out, const Overlay& overlay, double scale,
                      const Palette<std::string>& paints);

}  // namespace pathrace::results
