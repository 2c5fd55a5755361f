// `scenarios families`: what can be generated, and with which parameters.
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "bench/cli/scenarios/verb.hpp"
#include "core/names.hpp"
#include "scenarios/family.hpp"

namespace pathrace::bench::cli {
namespace {

using Json = nlohmann::ordered_json;
using scenarios::Family;

struct FamiliesOptions {
  std::string name;
  bool json = false;
};

std::vector<Family> chosen_families(const std::string& name) {
  if (name.empty()) return scenarios::families();
  std::vector<std::string> known;
  for (const Family& family : scenarios::families()) {
    if (family.name == name) return {family};
    known.push_back(family.name);
  }
  throw InputError(unknown_name("family", name, known));
}

Json object_of(const Family& family) {
  Json parameters = Json::array();
  for (const ParameterCard& card : family.parameters) {
    parameters.push_back({{"name", card.name},
                          {"type", card.type},
                          {"default", card.default_value},
                          {"range", card.range},
                          {"unit", card.unit},
                          {"meaning", card.meaning}});
  }
  return {{"name", family.name},
          {"form", family.form},
          {"summary", family.summary},
          {"listed", family.library.size()},
          {"parameters", parameters}};
}

void print_parameters(const Family& family) {
  fmt::print("\n{:<12} {:<10} {:<24} {:<7} meaning\n", "parameter", "default", "range", "unit");
  for (const ParameterCard& card : family.parameters) {
    fmt::print("{:<12} {:<10} {:<24} {:<7} {}\n", card.name, card.default_value, card.range, card.unit,
               card.meaning);
  }
}

int list_families(const FamiliesOptions& options) {
  Json array = Json::array();
  for (const Family& family : chosen_families(options.name)) {
    if (options.json) {
      array.push_back(object_of(family));
      continue;
    }
    fmt::print("{:<46} {}\n", family.form, family.summary);
    if (!options.name.empty()) print_parameters(family);
  }
  if (options.json) fmt::print("{}\n", array.dump(1));
  return done;
}

}  // namespace

void add_scenarios_families(CLI::App& parent) {
  auto options = std::make_shared<FamiliesOptions>();
  CLI::App* verb = add_verb(parent, "families", "what can be generated, and with which parameters", "trap-u",
                            [options] { return list_families(*options); });
  verb->add_option("name", options->name, "a family; without it, all of them")->type_name("FAMILY");
  verb->add_flag("--json", options->json, "print a JSON array, with the parameters");
}

}  // namespace pathrace::bench::cli
