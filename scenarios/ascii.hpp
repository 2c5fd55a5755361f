// A scenario as text, for terminals.
#pragma once

#include <iosfwd>

#include "core/grid.hpp"
#include "core/scenario.hpp"

namespace pathrace::scenarios {

/// One character per cell: `S` start, `G` goal, `#` blocked, `.` free. Maps wider than 120 columns are drawn
/// with one character per block of cells: blocked where at least half of the block is.
void print_ascii(std::ostream& out, const Scenario& scenario);
/// The same without start and goal.
void print_ascii(std::ostream& out, const OccupancyGrid& grid);

}  // namespace pathrace::scenarios
