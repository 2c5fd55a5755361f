// Obstacles grown by the robot's radius, so that a point may stand for a disc.
#pragma once

#include "core/grid.hpp"

namespace pathrace::scenarios {

/// A free cell stays free when its centre keeps at least `radius` cell edges from every blocked cell, which
/// is a square of side 1: a robot of that radius fits into a corridor of 2 * radius edges, and into none that
/// is narrower. A robot that fits exactly fits, to a part in 10^9: 0.15 m / 0.05 m is just below 3. The map's
/// border is no obstacle.
///
/// This holds for paths from centre to centre. An any-angle path may run along a grown cell's edge, half a
/// cell nearer to the obstacle. Time and memory are linear in the cells, whatever the radius. Throws
/// InputError unless the radius is a number of at least 0.
OccupancyGrid inflated(const OccupancyGrid& grid, double radius);

}  // namespace pathrace::scenarios
