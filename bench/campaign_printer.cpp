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

template <typename Number>
toml::array list_of(const std::vector<std::array<Number, 4>>& pairs) {
  toml::array list;
  for (const auto& [start_x, start_y, goal_x, goal_y] : pairs) {
    list.push_back(toml::array{start_x, start_y, goal_x, goal_y});
  }
  return list;
}

toml::table table_of(const MapChoice& map) {
  toml::table table{{"map", map.file.string()}};
  if (map.options.radius > 0) table.insert("radius", map.options.radius);
  if (map.options.resolution) table.insert("resolution", *map.options.resolution);
  table.insert("unknown", std::string(name(map.options.unknown)));
  if (map.queries > 0) {
    table.insert("queries", whole(map.queries));
    table.insert("seed", whole(map.seed));
  }
  if (!map.pairs.empty()) table.insert("pairs", list_of(map.pairs));
  if (!map.pairs_m.empty()) table.insert("pairs_m", list_of(map.pairs_m));
  return table;
}

toml::table table_of(const ScenarioChoice& choice) {
  toml::table table;
  if (choice.map) {
    table = table_of(*choice.map);
  } else {
    toml::array select;
    for (const std::string& pattern : choice.select) select.push_back(pattern);
    table.insert("select", std::move(select));
  }
  if (choice.rule) table.insert("rule", std::string(name(*choice.rule)));
  if (choice.budget) table.insert("budget", table_of(*choice.budget));
  return table;
}

}  // namespace

std::string to_toml(const Campaign& campaign) {
  toml::table head{
      {"name", campaign.name}, {"seed", whole(campaign.seed)}, {"repetitions", whole(campaign.repetitions)}};
  if (campaign.maps) {
    head.insert("maps", campaign.maps->string());
    head.insert("queries_per_map", whole(campaign.limits.queries_per_map));
    head.insert("max_side", campaign.limits.max_side);
  }
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
