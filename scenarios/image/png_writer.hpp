// A grid as a picture: one pixel a cell.
#pragma once

#include <ostream>

#include "core/grid.hpp"

namespace pathrace::scenarios {

/// A PNG of one bit a pixel, free cells white, blocked ones black. Throws EnvironmentError when libpng or the
/// stream fails.
void write_png(std::ostream& out, const OccupancyGrid& grid);

}  // namespace pathrace::scenarios
