#include "results/scenarios_csv.hpp"

#include <algorithm>

#include "core/hash.hpp"
#include "results/csv.hpp"
#include "results/number_text.hpp"

namespace pathrace::results {
namespace {

std::string print(const std::optional<double>& value) {
  return value ? print_number(*value) : "";
}

std::string feature_text(const ScenarioRow& row, const std::string& name) {
  const auto found = std::find_if(row.features.begin(), row.features.end(),
                                  [&name](const FeatureValue& feature) { return feature.name == name; });
  return found == row.features.end() ? "" : print(found->value);
}

}  // namespace

void write_scenarios_header(std::ostream& out, const std::vector<std::string>& features) {
  std::vector<std::string> fields = {"id",
                                     "family",
                                     "width",
                                     "height",
                                     "rule",
                                     "start_x",
                                     "start_y",
                                     "goal_x",
                                     "goal_y",
                                     "optimum",
                                     "any_angle_optimum",
                                     "hash"};
  fields.insert(fields.end(), features.begin(), features.end());
  write_csv_line(out, fields);
}

void write_scenario_line(std::ostream& out, const ScenarioRow& row,
                         const std::vector<std::string>& features) {
  std::vector<std::string> fields = {row.id,
                                     std::string(row.family()),
                                     std::to_string(row.width),
                                     std::to_string(row.height),
                                     std::string(name(row.rule)),
                                     std::to_string(row.start.x),
                                     std::to_string(row.start.y),
                                     std::to_string(row.goal.x),
                                     std::to_string(row.goal.y),
                                     print(row.optimum),
                                     print(row.any_angle_optimum),
                                     hex(row.hash)};
  for (const std::string& feature : features) fields.push_back(feature_text(row, feature));
  write_csv_line(out, fields);
}

void write_scenarios_csv(std::ostream& out, const Store& store) {
  const std::vector<std::string> features = store.feature_names();
  write_scenarios_header(out, features);
  store.for_each_scenario([&](const ScenarioRow& row) { write_scenario_line(out, row, features); });
}

}  // namespace pathrace::results
