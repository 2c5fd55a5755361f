#include "results/scenario_row.hpp"

namespace pathrace::results {

ScenarioRow make_scenario_row(const Scenario& scenario) {
  ScenarioRow row;
  row.id = scenario.id;
  row.width = scenario.grid().width();
  row.height = scenario.grid().height();
  row.rule = scenario.terrain.rule;
  row.start = scenario.start;
  row.goal = scenario.goal;
  if (scenario.optimum.length) row.optimum = scenario.optimum.length->value();
  row.hash = content_hash(scenario);
  return row;
}

}  // namespace pathrace::results
