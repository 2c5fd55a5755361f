// References: what gaps count from, proven once per scenario and never in a trial's time.
//
// On the lattice it is the exact search of core; at any angle it is the answer of the planner
// `any-angle-optimum`, which the tests prove against the full visibility graph, through the referee like any
// other answer. Runs through dynamic worlds count from the bound that their world carries.
#pragma once

#include "core/path.hpp"
#include "core/referee.hpp"
#include "core/scenario.hpp"

namespace pathrace::bench {

/// Proves what gaps on this track count from, where it is not proven yet; a function of map, rule, start and
/// goal alone. `referee` is the map's. Throws std::logic_error when the any-angle search fails.
void prove_reference(Scenario& scenario, Track track, const Referee& referee);

}  // namespace pathrace::bench
