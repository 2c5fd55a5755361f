// pathrace for other programs: read a map, plan a path, in one include.
//
//   const pathrace::GridMap map = pathrace::read_map("office.yaml");
//   const pathrace::Plan plan = pathrace::plan(map, pathrace::Metres{0, 0}, pathrace::Metres{5, 2}, "jps");
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/budget.hpp"
#include "core/cell.hpp"
#include "core/error.hpp"
#include "core/grid.hpp"
#include "core/record.hpp"
#include "scenarios/map_reader.hpp"

namespace pathrace {

using scenarios::GridMap;
using scenarios::MapOptions;
using scenarios::read_map;
using Metres = scenarios::WorldPoint;  ///< a place in the map's frame

/// A map of a grid in memory: its lower left corner is the origin of its frame, `resolution` is in metres per
/// cell edge. Throws InputError unless that is above 0.
GridMap map_of(OccupancyGrid grid, double resolution = 1);

struct PlanOptions {
  MoveRule rule = MoveRule::strict;  ///< of planners that step from cell to cell
  Budget budget = {};                ///< no limit: the planner's default budget
  std::uint64_t seed = 1;            ///< the same seed gives the same path
  int threads = 1;                   ///< does not change the path
};

/// A path that the referee found legal, or why there is none.
struct Plan {
  Verdict verdict = Verdict::no_path;  ///< solved, no_path, budget, gave_up or timeout
  std::vector<Point> points;           ///< from start to goal; cell (x, y) has its centre at the point (x, y)
  std::vector<Metres> points_m;        ///< the same points in the map's frame
  double length = 0;                   ///< cell edges
  double length_m = 0;
  Work work;

  explicit operator bool() const { return verdict == Verdict::solved; }
};

/// Plans from cell to cell; (0, 0) is the upper left one. `planner` is a call such as "jps" or
/// "as:dead_end=backtrack,ants=20", as on the command line. May be called from several threads at once.
///
/// Throws InputError for an unknown planner or parameter, and when start or goal is no free cell of the map;
/// Unsupported when the planner is for other questions; std::runtime_error when the planner fails or breaks
/// the rules.
Plan plan(const GridMap& map, Cell start, Cell goal, std::string_view planner,
          const PlanOptions& options = {});

/// The same between the cells that hold two places.
Plan plan(const GridMap& map, Metres start, Metres goal, std::string_view planner,
          const PlanOptions& options = {});

}  // namespace pathrace
