// The oracle: optima found the slow and obvious way, to check the fast ways against.
//
// It asks a grid only which cells are free, spells the four move rules out once more and compares lengths
// with its own exact arithmetic, so that it shares no mistake with the searches it judges.
#pragma once

#include <cstdint>
#include <optional>

#include "core/cell.hpp"
#include "core/grid.hpp"
#include "core/lattice_length.hpp"
#include "core/move_rule.hpp"

namespace pathrace::testing {

/// -1, 0 or 1: the sign of straight + diagonal * sqrt 2, exactly. Counts below 2^62.
int sign_of(std::int64_t straight, std::int64_t diagonal);

/// Is the step between neighbouring cells legal? `from` and `to` may be any cells.
bool oracle_step(const OccupancyGrid& grid, MoveRule rule, Cell from, Cell to);

/// The least length of a lattice path, by Bellman-Ford over all cells; nothing when there is no way.
std::optional<LatticeLength> oracle_optimum(const OccupancyGrid& grid, MoveRule rule, Cell start, Cell goal);

/// Is there any lattice path? By flood fill.
bool oracle_reachable(const OccupancyGrid& grid, MoveRule rule, Cell start, Cell goal);

}  // namespace pathrace::testing
