// Walks of ants that never walked.
#pragma once

#include <vector>

#include "algorithms/aco/walk.hpp"
#include "core/cell.hpp"

namespace pathrace::testing {

/// An arrived walk over these cells, each a neighbour of the one before.
algorithms::Walk walk_over(const std::vector<Cell>& cells);

/// The cells that the walk comes to, the nest's start first.
std::vector<Cell> cells_over(const algorithms::Nest& nest, const algorithms::Walk& walk);

}  // namespace pathrace::testing
