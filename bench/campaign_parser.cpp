// From TOML to a campaign, with the place of every fault.
#include <fmt/format.h>
#include <toml++/toml.h>

#include <cmath>

#include "bench/campaign.hpp"
#include "bench/toml_limits.hpp"
#include "core/error.hpp"
#include "core/names.hpp"
#include "core/parameters.hpp"
#include "core/plain_text.hpp"
#include "scenarios/file_bytes.hpp"
#include "scenarios/text.hpp"

namespace pathrace::bench {
namespace {

using pathrace::scenarios::OfferLimits;
using pathrace::scenarios::UnknownPolicy;

constexpr std::uint64_t most_repetitions = 1'000'000;
constexpr std::int64_t most_queries = 1'000'000;
constexpr std::uintmax_t longest_campaign = std::uintmax_t{16} << 20;

class Parser {
 public:
  explicit Parser(std::string file) : file_(std::move(file)) {}

  Campaign campaign(const toml::table& root) const {
    require_keys(root, {"campaign", "budget", "planner", "scenarios"});
    Campaign campaign;
    const toml::table& head = table_at(root, "campaign", root);
    require_keys(head, {"name", "seed", "repetitions", "maps", "queries_per_map", "max_side"});
    campaign.name = name(need(head, "name"));
    if (campaign.name.empty() || campaign.name.find('/') != std::string::npos) {
      fail(need(head, "name"),
           "campaign.name must be a word that can name a folder, got '" + campaign.name + "'");
    }
    if (const toml::node* node = head.get("seed")) campaign.seed = count(*node, "seed", 0, INT64_MAX);
    if (const toml::node* node = head.get("repetitions")) {
      campaign.repetitions = count(*node, "repetitions", 1, most_repetitions);
    }
    if (const toml::node* node = head.get("maps")) campaign.maps = text(*node);
    if (const toml::node* node = head.get("queries_per_map")) {
      campaign.limits.queries_per_map = count(*node, "queries_per_map", 1, most_queries);
    }
    if (const toml::node* node = head.get("max_side")) {
      campaign.limits.max_side = static_cast<int>(count(*node, "max_side", 1, OccupancyGrid::max_side));
    }
    if (const toml::node* node = root.get("budget")) campaign.budget = budget(*node);
    for (const toml::node& node : tables_at(root, "planner"))
      campaign.planners.push_back(planner(*node.as_table()));
    if (root.get("scenarios") == nullptr) return campaign;  // a folder of maps may stand for them
    for (const toml::node& node : tables_at(root, "scenarios")) {
      campaign.scenarios.push_back(scenarios(*node.as_table(), campaign.limits));
    }
    return campaign;
  }

  [[noreturn]] void fail(const toml::source_region& where, const std::string& what) const {
    throw InputError(fmt::format("{}:{}:{}: {}", file_, where.begin.line, where.begin.column, what));
  }

 private:
  [[noreturn]] void fail(const toml::node& node, const std::string& what) const { fail(node.source(), what); }

  void require_keys(const toml::table& table, const std::vector<std::string>& known) const {
    for (const auto& [key, node] : table) {
      bool found = false;
      for (const std::string& candidate : known) found = found || candidate == key.str();
      if (!found) fail(key.source(), unknown_name("key", key.str(), known));
    }
  }

  const toml::node& need(const toml::table& table, std::string_view key) const {
    const toml::node* node = table.get(key);
    if (node == nullptr) fail(table, fmt::format("'{}' is missing", key));
    return *node;
  }

  const toml::table& table_at(const toml::table& parent, std::string_view key,
                              const toml::node& where) const {
    const toml::node* node = parent.get(key);
    if (node == nullptr) fail(where, fmt::format("the table [{}] is missing", key));
    if (!node->is_table()) fail(*node, fmt::format("'{}' must be a table, [{}]", key, key));
    return *node->as_table();
  }

  const toml::array& tables_at(const toml::table& root, std::string_view key) const {
    const toml::node* node = root.get(key);
    if (node == nullptr) fail(root, fmt::format("at least one [[{}]] is needed", key));
    const toml::array* list = node->as_array();
    if (list == nullptr || list->empty())
      fail(*node, fmt::format("'{}' must be a list of tables, [[{}]]", key, key));
    for (const toml::node& item : *list) {
      if (!item.is_table()) fail(item, fmt::format("'{}' must be a list of tables, [[{}]]", key, key));
    }
    return *list;
  }

  std::string text(const toml::node& node) const {
    if (const auto value = node.value_exact<std::string>()) return *value;
    fail(node, "expected a text in quotes");
  }

  // What tables, files and terminals will show.
  std::string name(const toml::node& node) const {
    std::string value = text(node);
    if (is_plain_text(value)) return value;
    fail(node, fmt::format("'{}'; expected a name without control characters", escape_controls(value)));
  }

  std::uint64_t count(const toml::node& node, std::string_view what, std::int64_t low,
                      std::int64_t high) const {
    const auto value = node.value_exact<std::int64_t>();
    if (!value) fail(node, fmt::format("'{}' must be an integer in {}..{}", what, low, high));
    if (*value < low || *value > high) {
      fail(node, fmt::format("'{}' must be an integer in {}..{}, got {}", what, low, high, *value));
    }
    return static_cast<std::uint64_t>(*value);
  }

  Budget budget(const toml::node& node) const {
    const toml::table* table = node.as_table();
    if (table == nullptr) fail(node, "'budget' must be a table");
    require_keys(*table, {"evaluations", "iterations", "checks", "wall_s"});
    Budget budget;
    const auto limit = [&](std::string_view key) -> std::optional<std::uint64_t> {
      const toml::node* value = table->get(key);
      if (value == nullptr) return std::nullopt;
      return count(*value, key, 1, INT64_MAX);
    };
    budget.evaluations = limit("evaluations");
    budget.iterations = limit("iterations");
    budget.checks = limit("checks");
    if (const toml::node* wall = table->get("wall_s")) {
      const auto seconds = wall->value<double>();
      if (!seconds || !std::isfinite(*seconds) || *seconds <= 0)
        fail(*wall, "'wall_s' must be a number of seconds above 0");
      budget.wall_s = *seconds;
    }
    if (budget.unlimited()) fail(node, "a budget must limit evaluations, iterations, checks or wall_s");
    return budget;
  }

  std::string parameter_value(const toml::node& node) const {
    if (const auto value = node.value_exact<std::string>()) return *value;
    if (const auto value = node.value_exact<bool>()) return *value ? "true" : "false";
    if (const auto value = node.value_exact<std::int64_t>()) return std::to_string(*value);
    if (const auto value = node.value_exact<double>()) return print_real(*value);
    fail(node, "a parameter must be a number, a text, true or false, or a list of these");
  }

  PlannerChoice planner(const toml::table& table) const {
    require_keys(table, {"name", "label", "params"});
    PlannerChoice choice;
    choice.name = text(need(table, "name"));
    if (const toml::node* label = table.get("label")) choice.label = name(*label);
    const toml::node* params = table.get("params");
    if (params == nullptr) return choice;
    if (!params->is_table()) fail(*params, "'params' must be a table, { name = value }");
    for (const auto& [key, node] : *params->as_table()) {
      std::vector<std::string> values;
      if (const toml::array* list = node.as_array()) {
        for (const toml::node& item : *list) values.push_back(parameter_value(item));
        if (values.empty()) fail(node, "a list of values must not be empty");
      } else {
        values.push_back(parameter_value(node));
      }
      choice.values.emplace_back(std::string(key.str()), std::move(values));
    }
    return choice;
  }

  double number(const toml::node& node, std::string_view what, double low) const {
    const auto value = node.value<double>();
    if (!value || !std::isfinite(*value) || *value < low) {
      fail(node, fmt::format("'{}' must be a number of at least {}", what, low));
    }
    return *value;
  }

  template <typename Enum>
  Enum choice(const toml::node& node, std::string_view kind) const {
    try {
      return parse_name<Enum>(kind, text(node));
    } catch (const InputError& fault) {
      fail(node, fault.what());
    }
  }

  // Start and goal: four numbers.
  template <typename Number>
  std::vector<std::array<Number, 4>> pairs(const toml::node& node, std::string_view form) const {
    const toml::array* list = node.as_array();
    if (list == nullptr || list->empty()) fail(node, fmt::format("expected a list of {}", form));
    std::vector<std::array<Number, 4>> pairs;
    for (const toml::node& item : *list) {
      const toml::array* values = item.as_array();
      if (values == nullptr || values->size() != 4) fail(item, fmt::format("expected {}", form));
      std::array<Number, 4> pair{};
      for (std::size_t i = 0; i < 4; ++i) {
        const auto value = values->get(i)->value<Number>();
        if (!value) fail(*values->get(i), fmt::format("expected {}", form));
        pair[i] = *value;
      }
      pairs.push_back(pair);
    }
    return pairs;
  }

  MapChoice map(const toml::table& table, const OfferLimits& limits) const {
    require_keys(table, {"map", "radius", "unknown", "resolution", "rule", "queries", "seed", "pairs",
                         "pairs_m", "budget"});
    MapChoice map;
    map.file = text(need(table, "map"));
    if (const toml::node* node = table.get("radius")) map.options.radius = number(*node, "radius", 0);
    if (const toml::node* node = table.get("resolution")) {
      map.options.resolution = number(*node, "resolution", 1e-9);
    }
    if (const toml::node* node = table.get("unknown")) {
      map.options.unknown = choice<UnknownPolicy>(*node, "policy for unknown cells");
    }
    if (const toml::node* node = table.get("pairs")) {
      map.pairs = pairs<int>(*node, "[start x, start y, goal x, goal y] in cells");
    }
    if (const toml::node* node = table.get("pairs_m")) {
      map.pairs_m = pairs<double>(*node, "[start x, start y, goal x, goal y] in metres");
    }
    if (map.pairs.empty() && map.pairs_m.empty()) map.queries = limits.queries_per_map;
    if (const toml::node* node = table.get("queries")) map.queries = count(*node, "queries", 1, most_queries);
    if (const toml::node* node = table.get("seed")) map.seed = count(*node, "seed", 0, INT64_MAX);
    return map;
  }

  std::vector<std::string> select(const toml::table& table) const {
    require_keys(table, {"select", "rule", "budget"});
    const toml::node& select = need(table, "select");
    const toml::array* list = select.as_array();
    if (list == nullptr || list->empty()) fail(select, "'select' must be a list of scenario ids or patterns");
    std::vector<std::string> patterns;
    for (const toml::node& item : *list) patterns.push_back(text(item));
    return patterns;
  }

  ScenarioChoice scenarios(const toml::table& table, const OfferLimits& limits) const {
    ScenarioChoice chosen;
    if (table.get("map") != nullptr) {
      chosen.map = map(table, limits);
    } else {
      chosen.select = select(table);
    }
    if (const toml::node* node = table.get("rule")) chosen.rule = choice<MoveRule>(*node, "move rule");
    if (const toml::node* node = table.get("budget")) chosen.budget = budget(*node);
    return chosen;
  }

  std::string file_;
};

}  // namespace

Campaign parse_campaign(std::string_view text, const std::string& file) {
  const Parser parser(file);
  text = scenarios::text_of(text, file);
  require_shallow_toml(text, file);
  toml::table root;
  try {
    root = toml::parse(text, file);
  } catch (const toml::parse_error& error) {
    parser.fail(error.source(), std::string(error.description()));
  }
  return parser.campaign(root);
}

Campaign read_campaign(const std::filesystem::path& file) {
  Campaign campaign = parse_campaign(scenarios::whole_file(file, longest_campaign), file.string());
  const std::filesystem::path folder = std::filesystem::absolute(file).parent_path();
  const auto settle = [&](std::filesystem::path& path) { path = (folder / path).lexically_normal(); };
  if (campaign.maps) settle(*campaign.maps);
  for (ScenarioChoice& choice : campaign.scenarios) {
    if (choice.map) settle(choice.map->file);
  }
  return campaign;
}

}  // namespace pathrace::bench
