// `scenarios list`: the library's finite list, with proven optima and hashes.
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "bench/cli/scenarios/verb.hpp"
#include "core/error.hpp"
#include "core/hash.hpp"
#include "scenarios/library.hpp"
#include "scenarios/sets.hpp"

namespace pathrace::bench::cli {
namespace {

using Json = nlohmann::ordered_json;

struct ListOptions {
  std::string family;
  std::string set;
  bool json = false;
};

// Ids below a prefix that ends at a slash: "trap-l", "dense/20-20", "trap-l/20/".
bool below(const std::string& id, std::string prefix) {
  if (prefix.empty()) return true;
  if (prefix.back() != '/') prefix += '/';
  return (id + '/').starts_with(prefix);
}

Json object_of(const Scenario& scenario) {
  return {{"id", scenario.id},
          {"family", scenario.id.substr(0, scenario.id.find('/'))},
          {"width", scenario.grid().width()},
          {"height", scenario.grid().height()},
          {"rule", name(scenario.terrain.rule)},
          {"start", {scenario.start.x, scenario.start.y}},
          {"goal", {scenario.goal.x, scenario.goal.y}},
          {"optimum", scenario.optimum.length ? Json(scenario.optimum.length->value()) : Json(nullptr)},
          {"hash", hex(content_hash(scenario))}};
}

std::vector<std::string> chosen_ids(const scenarios::Library& library, const ListOptions& options) {
  std::vector<std::string> ids;
  const std::vector<std::string> listed =
      options.set.empty() ? library.list() : scenarios::ids_of(scenarios::find_set(options.set), library);
  for (const std::string& id : listed) {
    if (below(id, options.family)) ids.push_back(id);
  }
  if (ids.empty()) {
    throw InputError(fmt::format("--family: nothing in the {} begins with '{}'",
                                 options.set.empty() ? "library" : "set", options.family));
  }
  return ids;
}

int list_as_json(const scenarios::Library& library, const std::vector<std::string>& ids) {
  Json array = Json::array();
  for (const std::string& id : ids) array.push_back(object_of(library.load(id)));
  fmt::print("{}\n", array.dump(1));
  return done;
}

int list_scenarios(const ListOptions& options) {
  const scenarios::Library library;
  const std::vector<std::string> ids = chosen_ids(library, options);
  if (options.json) return list_as_json(library, ids);
  fmt::print("{:<24} {:>9} {:<7} {:>10}  hash\n", "id", "size", "rule", "optimum");
  for (const std::string& id : ids) {
    const Scenario scenario = library.load(id);
    const std::string size = fmt::format("{}x{}", scenario.grid().width(), scenario.grid().height());
    fmt::print("{:<24} {:>9} {:<7} {:>10}  {}\n", id, size, name(scenario.terrain.rule),
               print_optimum(scenario), hex(content_hash(scenario)));
  }
  return done;
}

}  // namespace

void add_scenarios_list(CLI::App& parent) {
  auto options = std::make_shared<ListOptions>();
  CLI::App* verb = add_verb(parent, "list", "the library's list, with proven optima and hashes",
                            "--family trap-l/20", [options] { return list_scenarios(*options); });
  verb->add_option("--family", options->family, "only ids below this prefix")->type_name("PREFIX");
  verb->add_option("--set", options->set, "the scenarios of this set (see scenarios sets)")->type_name("SET");
  verb->add_flag("--json", options->json, "print a JSON array");
}

}  // namespace pathrace::bench::cli
