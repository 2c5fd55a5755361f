// The scout: one greedy walk to the goal, for its length only.
//
// C_nn, by which the literature sets the initial pheromone, is the length of a nearest-neighbour tour; on a
// grid it is that of a walk to the neighbour with the largest desirability, backwards out of dead ends. Never
// from exact search, which would tell the colony the optimum.
#pragma once

#include <cstdint>
#include <optional>

#include "algorithms/aco/nest.hpp"
#include "algorithms/aco/pheromone_rule.hpp"
#include "algorithms/aco/trail.hpp"

namespace pathrace::algorithms {

struct ScoutReport {
  std::optional<Scout> scout;   ///< nothing when the goal was not reached
  bool unreachable = false;     ///< every cell that can be reached was seen, the goal was not among them
  std::uint64_t decisions = 0;  ///< one per step forwards or backwards
};

/// At most `limit` decisions.
ScoutReport send_scout(const Nest& nest, const Trail& trail, std::uint64_t limit);

}  // namespace pathrace::algorithms
