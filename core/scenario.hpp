// A scenario: one question with a stable id.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "core/cell.hpp"
#include "core/grid.hpp"
#include "core/lattice_length.hpp"
#include "core/move_rule.hpp"
#include "core/world.hpp"

namespace pathrace {

/// A map and the rule of moving on it; shared by all queries on the same map.
struct Terrain {
  std::shared_ptr<const OccupancyGrid> grid;
  MoveRule rule = MoveRule::strict;
};

/// What exact search has proven about a scenario.
struct Optimum {
  bool proven = false;                  ///< false: nobody has searched yet
  std::optional<LatticeLength> length;  ///< empty and proven: there is no way
};

/// The same among all any-angle paths, whose rule (core/referee.hpp) asks for no move rule.
struct AnyAngleOptimum {
  bool proven = false;
  std::optional<double> length;  ///< in cell edges; empty and proven: there is no way
};

struct Scenario {
  std::string id;  ///< `family/params/seed`, `asr/fig5`, `movingai/<scen>/<k>`
  Terrain terrain;
  Cell start;
  Cell goal;
  Optimum optimum;
  AnyAngleOptimum any_angle_optimum;
  /// A dynamic world, or none. Where there is one it is the question, and what stands above is a still
  /// picture of its beginning, for tables and maps: a cell is blocked where its centre lies in a disc.
  std::shared_ptr<const World> world;

  const OccupancyGrid& grid() const { return *terrain.grid; }
};

/// Throws InvalidScenario unless start and goal are free cells of the map.
void require_valid(const Scenario& scenario);

/// Hash of map, rule, start and goal, or of the world: what the question is, whatever it is called.
std::uint64_t content_hash(const Scenario& scenario);

}  // namespace pathrace
