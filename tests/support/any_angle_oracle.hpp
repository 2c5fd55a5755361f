// The any-angle oracle: shortest paths for a point robot the slow and obvious way, to check the fast ways
// against.
//
// The full visibility graph over every corner of the grid, start and goal, with Dijkstra's algorithm. Whether
// a segment is legal is asked of every cell of the map and around it, in doubled integers: no line with the
// searches or the referee is shared.
#pragma once

#include <optional>

#include "core/cell.hpp"
#include "core/grid.hpp"

namespace pathrace::testing {

/// Least length of an any-angle path, in cell edges; nothing when there is no way. For small maps.
std::optional<double> oracle_any_angle(const OccupancyGrid& grid, Cell start, Cell goal);

}  // namespace pathrace::testing
