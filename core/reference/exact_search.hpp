// The reference: proves a scenario's optimum. No planner uses it, and it uses nothing of theirs.
//
// Dijkstra's algorithm over cells, with costs kept as integer counts of straight and diagonal steps. The
// queue orders by the counts' value as a double: two different lengths a + b sqrt 2 with a, b below N
// differ by at least 1 / (3N), far above the rounding of a double for every map that fits (N < 2^24), so
// the order is exact and equal lengths have equal keys.
#pragma once

#include "core/scenario.hpp"

namespace pathrace::reference {

/// The proven optimum from start to goal; its length is empty when there is no way. Expects free cells.
Optimum optimum(const Terrain& terrain, Cell start, Cell goal);

}  // namespace pathrace::reference
