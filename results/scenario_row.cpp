#include "results/scenario_row.hpp"

#include "core/gap.hpp"

namespace pathrace::results {

ScenarioRow make_scenario_row(const Scenario& scenario) {
  ScenarioRow row;
  row.id = scenario.id;
  row.width = scenario.grid().width();
  row.height = scenario.grid().height();
  row.rule = scenario.terrain.rule;
  row.start = scenario.start;
  row.goal = scenario.goal;
  row.optimum = reference_length(scenario, Track::lattice);
  row.any_angle_optimum = reference_length(scenario, Track::any_angle);
  row.hash = content_hash(scenario);
  return row;
}

}  // namespace pathrace::results
