// Paths that no planner would find.
#pragma once

#include <vector>

#include "core/cell.hpp"
#include "core/grid.hpp"
#include "core/move_rule.hpp"
#include "core/stream.hpp"

namespace pathrace::testing {

/// A legal path that comes to no cell twice: a random walk over new cells that steps back when it is stuck.
/// Empty when there is no way.
std::vector<Cell> crooked_path(const OccupancyGrid& grid, MoveRule rule, Cell start, Cell goal,
                               Stream stream);

}  // namespace pathrace::testing
