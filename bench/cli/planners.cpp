// `planners`: the catalogue.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "bench/cli/command.hpp"
#include "bench/roster.hpp"

namespace pathrace::bench::cli {
namespace {

using Json = nlohmann::ordered_json;

Json summary_of(const PlannerCard& card) {
  return {{"name", card.name},         {"kind", name(card.kind)},
          {"track", name(card.track)}, {"deterministic", card.deterministic},
          {"source", card.source},     {"version", card.version}};
}

// The letter that the specification marks a default's origin with.
std::string tag(Source source) {
  if (source == Source::literature) return "M";
  if (source == Source::ours) return "";
  return std::string(1, static_cast<char>(name(source)[0] - 'a' + 'A'));
}

Json object_of(const ParameterCard& parameter) {
  return {{"name", parameter.name},       {"type", parameter.type},      {"default", parameter.default_value},
          {"range", parameter.range},     {"unit", parameter.unit},      {"source", name(parameter.source)},
          {"tag", tag(parameter.source)}, {"meaning", parameter.meaning}};
}

template <typename Number>
Json or_null(const std::optional<Number>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json object_of(const Budget& budget) {
  return {{"evaluations", or_null(budget.evaluations)},
          {"iterations", or_null(budget.iterations)},
          {"checks", or_null(budget.checks)},
          {"wall_s", or_null(budget.wall_s)}};
}

int list_planners(bool json) {
  if (json) {
    Json array = Json::array();
    for (const PlannerCard& card : roster().cards()) array.push_back(summary_of(card));
    fmt::print("{}\n", array.dump(2));
    return done;
  }
  constexpr const char* line = "{:<{}} {:<9} {:<9} {}\n";
  std::size_t width = 0;
  for (const PlannerCard& card : roster().cards()) width = std::max(width, card.name.size());
  fmt::print(line, "name", width, "kind", "track", "what it does");
  for (const PlannerCard& card : roster().cards()) {
    fmt::print(line, card.name, width, name(card.kind), name(card.track), card.summary);
  }
  return done;
}

int describe_planner(const std::string& planner, bool json) {
  const PlannerCard& card = roster().find(planner);
  if (json) {
    Json description = summary_of(card);
    description["summary"] = card.summary;
    description["default_budget"] = object_of(card.default_budget);
    description["parameters"] = Json::array();
    for (const ParameterCard& parameter : card.parameters)
      description["parameters"].push_back(object_of(parameter));
    description["conditions"] = Json::array();
    for (const ConditionCard& condition : card.conditions) {
      description["conditions"].push_back({{"parameters", condition.parameters}, {"rule", condition.rule}});
    }
    fmt::print("{}\n", description.dump(2));
    return done;
  }
  fmt::print(
      "{}: {}\n\nkind     {}\ntrack    {}\nversion  {}\nsource   {}\nbudget   {} (when none is given)\n",
      card.name, card.summary, name(card.kind), name(card.track), card.version, card.source,
      to_string(card.default_budget));
  if (card.parameters.empty()) {
    fmt::print("\nIt has no parameters.\n");
    return done;
  }
  fmt::print("\nParameters (default, range, where the default comes from)\n");
  for (const ParameterCard& parameter : card.parameters) {
    fmt::print("  {:<18} {} = {}   {}{}{}   [{}]\n{:21}{}\n", parameter.name, parameter.type,
               parameter.default_value, parameter.range, parameter.unit.empty() ? "" : " ", parameter.unit,
               name(parameter.source), "", parameter.meaning);
  }
  if (!card.conditions.empty()) fmt::print("\nConditions\n");
  for (const ConditionCard& condition : card.conditions) fmt::print("  {}\n", condition.rule);
  return done;
}

}  // namespace

void add_planners(CLI::App& app) {
  auto json = std::make_shared<bool>(false);
  CLI::App* list = app.add_subcommand("planners", "list the planners, or describe one");
  list->footer("Example:\n  pathrace planners describe as");
  list->require_subcommand(0, 1);
  list->fallthrough();
  list->add_flag("--json", *json, "print JSON");
  auto planner = std::make_shared<std::string>();
  auto described = std::make_shared<bool>(false);
  CLI::App* describe =
      list->add_subcommand("describe", "parameters, default budget and source of one planner");
  describe->add_option("name", *planner, "a planner's name")->required()->type_name("NAME");
  describe->footer("Example:\n  pathrace planners describe as --json");
  describe->callback([described] { *described = true; });
  list->final_callback([json, planner, described] {
    throw ExitCode{*described ? describe_planner(*planner, *json) : list_planners(*json)};
  });
}

}  // namespace pathrace::bench::cli
