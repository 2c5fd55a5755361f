#include <fmt/format.h>

#include <memory>
#include <stdexcept>
#include <utility>

#include "bench/api/pathrace/pathrace.hpp"
#include "bench/executors.hpp"
#include "bench/roster.hpp"
#include "bench/trial.hpp"
#include "core/referee.hpp"

namespace pathrace {
namespace {

Cell cell_at(const GridMap& map, Metres place, std::string_view end) {
  if (const auto cell = map.frame.cell_at(place)) return *cell;
  throw InputError(fmt::format("the {} at {} m, {} m is not on the map", end, place.x, place.y));
}

void require_outcome(const TrialRecord& record, std::string_view planner) {
  switch (record.verdict) {
    case Verdict::crashed:
    case Verdict::invalid:
    case Verdict::out_of_memory:
      throw std::runtime_error(
          fmt::format("planner '{}' {}: {}", planner, name(record.verdict), record.note));
    case Verdict::unsupported: throw Unsupported(fmt::format("planner '{}': {}", planner, record.note));
    default: return;
  }
}

Plan plan_of(const TrialRecord& record, const scenarios::MapFrame& frame) {
  Plan plan;
  plan.verdict = record.verdict;
  plan.work = record.work;
  if (record.verdict != Verdict::solved) return plan;
  plan.points = record.answer->points;
  for (const Point point : plan.points) plan.points_m.push_back(frame.place_of(point));
  plan.length = record.metrics->length;
  plan.length_m = frame.metres(plan.length);
  return plan;
}

}  // namespace

GridMap map_of(OccupancyGrid grid, double resolution) {
  if (!(resolution > 0 && std::isfinite(resolution))) {
    throw InputError(fmt::format("a resolution of {}; expected metres per cell, above 0", resolution));
  }
  GridMap map;
  map.frame = {grid.width(), grid.height(), resolution, {}, 0};
  map.grid = std::make_shared<const OccupancyGrid>(std::move(grid));
  return map;
}

Plan plan(const GridMap& map, Cell start, Cell goal, std::string_view planner, const PlanOptions& options) {
  const Entrant entrant = bench::roster().enter(parse_call(planner));
  Scenario scenario;
  scenario.id = "map";
  scenario.terrain = {map.grid_for(start, goal), options.rule};
  scenario.start = start;
  scenario.goal = goal;
  require_valid(scenario);
  const std::unique_ptr<Executor> executor =
      bench::make_executor(options.threads == 1 ? "serial" : bench::default_backend(), options.threads);
  const Budget& budget = options.budget.unlimited() ? entrant.card->default_budget : options.budget;
  const TrialRecord record = bench::run_trial(entrant, scenario, Referee(scenario.terrain), budget,
                                              root_stream(options.seed, scenario.id, 0), *executor);
  require_outcome(record, planner);
  return plan_of(record, map.frame);
}

Plan plan(const GridMap& map, Metres start, Metres goal, std::string_view planner,
          const PlanOptions& options) {
  return plan(map, cell_at(map, start, "start"), cell_at(map, goal, "goal"), planner, options);
}

}  // namespace pathrace
