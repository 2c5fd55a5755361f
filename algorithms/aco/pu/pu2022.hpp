// The settings of the grouped-teaching colony.
#pragma once

#include <array>
#include <string_view>
#include <utility>

#include "algorithms/aco/colony_settings.hpp"
#include "algorithms/aco/dead_cells.hpp"
#include "algorithms/aco/pu/teaching.hpp"

namespace pathrace::algorithms {

enum class PuUpdate {
  all_ants,  ///< every ant that arrived adds Q / L, as in Ant System
  tiers,     ///< the iteration's best adds c Q1 / L, the best so far c Q2 / L
};

struct Pu2022Settings : ColonySettings {
  Pu2022Settings() {
    initial_pheromone = 8;
    dead_end = DeadEnd::backtrack;
  }

  DeadTable dead_table = DeadTable::global_dominated;
  PuUpdate update = PuUpdate::tiers;
  double global_factor = 2;
  bool others = false;
  int c_cap = 10;
  bool simplify = true;
  Teaching teaching = Teaching::paths;
  bool grouping = true;
  int students = 5;
};

}  // namespace pathrace::algorithms

namespace pathrace {
template <>
inline constexpr auto names_of<algorithms::PuUpdate> =
    std::to_array<std::pair<algorithms::PuUpdate, std::string_view>>({
        {algorithms::PuUpdate::all_ants, "all_ants"},
        {algorithms::PuUpdate::tiers, "tiers"},
    });
}  // namespace pathrace
