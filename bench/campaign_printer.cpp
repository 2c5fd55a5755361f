// From a campaign to TOML.
#include <fmt/format.h>
#include <toml++/toml.h>

#include <sstream>

#include "bench/campaign.hpp"

namespace pathrace::bench {
namespace {

std::int64_t whole(std::uint64_t number) {
  return static_cast<std::int64_t>(number);
}

toml::table table_of(const Budget& budget) {
  toml::table table;
  if (budget.evaluations) table.insert("evaluations", whole(*budget.evaluations));
  if (budget.iterations) table.insert("iterations", whole(*budget.iterations));
  if (budget.checks) table.insert("checks", whole(*budget.checks));
  if (budget.wall_s) table.insert("wall_s", *budget.wall_s);
  table.is_inline(true);
  return table;
}

toml::table table_of(const PlannerChoice& planner) {
  toml::table table{{"name", planner.name}};
  if (!planner.label.empty()) table.insert("label", planner.label);
  if (planner.values.empty()) return table;
  toml::table params;
  for (const auto& [key, values] : planner.values) {
    toml::array list;
    for (const std::string& value : values) list.push_back(value);
    if (values.size() == 1) {
      params.insert(key, values.front());
    } else {
      params.insert(key, std::move(list));
    }
  }
  params.is_inline(true);
  table.insert("params", std::move(params));
  return table;
}

toml::table table_of(const ScenarioChoice& choice) {
  toml::array select;
  for (const std::string& pattern : choice.select) select.push_back(pattern);
  toml::table table{{"select", std::move(select)}};
  if (choice.budget) table.insert("budget", table_of(*choice.budget));
  return table;
}

}  // namespace

std::string to_toml(const Campaign& campaign) {
  toml::table head{
      {"name", campaign.name}, {"seed", whole(campaign.seed)}, {"repetitions", whole(campaign.repetitions)}};
  if (campaign.maps) head.insert("maps", campaign.maps->string());
  toml::array planners;
  for (const PlannerChoice& planner : campaign.planners) planners.push_back(table_of(planner));
  toml::array scenarios;
  for (const ScenarioChoice& choice : campaign.scenarios) scenarios.push_back(table_of(choice));
  toml::table root{{"campaign", std::move(head)}};
  if (campaign.budget) root.insert("budget", table_of(*campaign.budget));
  root.insert("planner", std::move(planners));
  root.insert("scenarios", std::move(scenarios));
  std::ostringstream text;
  text << root << "\n";
  return text.str();
}

}  // namespace pathrace::bench
