// Scenarios as MovingAI files, for other people's tools.
#pragma once

#include <ostream>
#include <string>

#include "core/grid.hpp"
#include "core/scenario.hpp"

namespace pathrace::scenarios {

/// A `.map` file: free cells as `.`, blocked ones as `@`. Throws EnvironmentError when the stream fails.
void write_map(std::ostream& out, const OccupancyGrid& grid);

/// A `.scen` file of one query, tab separated, the optimum with 8 decimals. `map_name` goes into the map
/// field. Throws InputError for what the format cannot say: no proven optimum, no way at all, a move rule
/// other than `strict`, a map name that is empty or holds control characters. Throws EnvironmentError when
/// the stream fails.
void write_scen(std::ostream& out, const std::string& map_name, const Scenario& scenario);

}  // namespace pathrace::scenarios
