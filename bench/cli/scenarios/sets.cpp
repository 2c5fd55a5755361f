// `scenarios sets`: the named sets, to race on and to cite.
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "bench/cli/scenarios/verb.hpp"
#include "core/hash.hpp"
#include "scenarios/sets.hpp"

namespace pathrace::bench::cli {
namespace {

using Json = nlohmann::ordered_json;

struct SetsOptions {
  std::string name;
  bool json = false;
};

std::vector<scenarios::ScenarioSet> chosen_sets(const SetsOptions& options) {
  return options.name.empty() ? scenarios::sets() : std::vector{scenarios::find_set(options.name)};
}

Json object_of(const scenarios::ScenarioSet& set, const std::vector<std::string>& ids, std::uint64_t hash) {
  return {{"name", set.name},       {"library", scenarios::library_version},
          {"summary", set.summary}, {"scenarios", ids.size()},
          {"hash", hex(hash)},      {"ids", ids}};
}

int list_sets(const SetsOptions& options) {
  const scenarios::Library library;
  Json array = Json::array();
  if (!options.json) fmt::print("{:<10} {:>9}  {:<16}  what it holds\n", "set", "scenarios", "hash");
  for (const scenarios::ScenarioSet& set : chosen_sets(options)) {
    const std::vector<std::string> ids = scenarios::ids_of(set, library);
    const std::uint64_t hash = scenarios::hash_of(ids, library);
    if (options.json) {
      array.push_back(object_of(set, ids, hash));
      continue;
    }
    fmt::print("{:<10} {:>9}  {}  {}\n", set.name, ids.size(), hex(hash), set.summary);
    if (options.name.empty()) continue;
    fmt::print("cite as: pathrace library v{}, set {} ({})\n", scenarios::library_version, set.name,
               hex(hash));
    for (const std::string& id : ids) fmt::print("{}\n", id);
  }
  if (options.json) fmt::print("{}\n", array.dump(1));
  return done;
}

}  // namespace

void add_scenarios_sets(CLI::App& parent) {
  auto options = std::make_shared<SetsOptions>();
  CLI::App* verb = add_verb(parent, "sets", "the named sets with their hashes, or the scenarios of one",
                            "traps", [options] { return list_sets(*options); });
  verb->add_option("name", options->name, "a set; without it, all of them")->type_name("SET");
  verb->add_flag("--json", options->json, "print a JSON array, with the ids");
}

}  // namespace pathrace::bench::cli
