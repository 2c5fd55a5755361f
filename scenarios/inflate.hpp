// Obstacles grown by the robot's radius, so that a point may stand for a disc.
#pragma once

#include "core/grid.hpp"

namespace pathrace::scenarios {

/// Every cell whose centre is at most `radius` cell edges from the centre of a blocked cell is blocked, as in
/// costmap_2d. Exact, but for a part in 10^9 in the radius' favour: 0.15 m / 0.05 m is just below 3. The
/// map's border is no obstacle. Throws InputError unless the radius is a number of at least 0.
OccupancyGrid inflated(const OccupancyGrid& grid, double radius);

}  // namespace pathrace::scenarios
