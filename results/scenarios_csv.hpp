// scenarios.csv: a line per scenario, with a column per feature.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "results/scenario_row.hpp"
#include "results/store.hpp"

namespace pathrace::results {

/// id,family,width,height,rule,start_x,start_y,goal_x,goal_y,optimum,any_angle_optimum,hash and these
/// features.
void write_scenarios_header(std::ostream& out, const std::vector<std::string>& features);
/// A missing value is an empty field.
void write_scenario_line(std::ostream& out, const ScenarioRow& row, const std::vector<std::string>& features);

/// Every scenario that the store describes, with every feature that it holds.
void write_scenarios_csv(std::ostream& out, const Store& store);

}  // namespace pathrace::results
