// Planners: a question and a context in, a path out.
//
// A planner sees the map, the rule, start and goal; never the scenario's id or optimum. It has no state
// between calls that could change an answer: what `prepare` keeps is scratch memory and tables of the map.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "core/executor.hpp"
#include "core/meter.hpp"
#include "core/overlay.hpp"
#include "core/path.hpp"
#include "core/scenario.hpp"
#include "core/stream.hpp"

namespace pathrace {

/// The question as a planner sees it.
struct Problem {
  const OccupancyGrid& grid;
  MoveRule rule;
  Cell start;
  Cell goal;
};

/// All that the harness lends to a planner for one trial.
struct Context {
  Stream stream;
  Executor& executor;
  Meter& meter;
  Overlay* overlay = nullptr;  ///< where a planner may draw what it thinks; none in a race
};

/// A path from start to goal; nothing when the planner found none.
using Answer = std::optional<Path>;

/// A planner bound to one map, for any number of queries, one at a time.
class MapPlanner {
 public:
  MapPlanner() = default;
  MapPlanner(const MapPlanner&) = delete;
  MapPlanner& operator=(const MapPlanner&) = delete;
  virtual ~MapPlanner() = default;

  virtual Answer plan(Cell start, Cell goal, Context& context) = 0;
};

/// Binds a planner with its settings to a map. The terrain outlives the result.
using Planner = std::function<std::unique_ptr<MapPlanner>(const Terrain&)>;

/// A planner that prepares nothing: `plan(problem, context)` is all there is.
using PlanFunction = std::function<Answer(const Problem&, Context&)>;
Planner unprepared(PlanFunction plan);

}  // namespace pathrace
