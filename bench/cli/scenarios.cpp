// `scenarios`: what the library holds, how it looks, and whether a file is sound.
#include <fmt/format.h>

#include "bench/cli/options.hpp"
#include "bench/cli/scenarios/verb.hpp"
#include "scenarios/library.hpp"

namespace pathrace::bench::cli {

#define PATHRACE_VERB(add) void add(CLI::App& parent);
#include "bench/cli/scenarios/verbs.def"
#undef PATHRACE_VERB

CLI::App* add_verb(CLI::App& parent, const std::string& verb, const std::string& summary,
                   const std::string& example, std::function<int()> body) {
  return add_command(parent, verb, summary, "pathrace scenarios " + verb + " " + example, std::move(body));
}

Scenario proven_scenario(const std::string& id, const std::string& maps) {
  Scenario scenario = scenarios::Library(maps_folder(maps)).load(id);
  scenarios::prove(scenario);
  return scenario;
}

std::string print_optimum(const Scenario& scenario) {
  return scenario.optimum.length ? fmt::format("{:.4f}", scenario.optimum.length->value()) : "no way";
}

void add_scenario_options(CLI::App& verb, std::string& id, std::string& maps) {
  verb.add_option("id", id, "a scenario")->required()->type_name("ID");
  verb.add_option("--maps", maps, "folder of recorded maps, for movingai/... and ros/... scenarios")
      ->type_name("DIR");
}

void add_scenarios(CLI::App& app) {
  CLI::App* parent = app.add_subcommand("scenarios", "list, show, export or check scenarios");
  parent->require_subcommand(1);
  parent->footer("Example:\n  pathrace scenarios show trap-u/20/3");
#define PATHRACE_VERB(add) add(*parent);
#include "bench/cli/scenarios/verbs.def"
#undef PATHRACE_VERB
}

}  // namespace pathrace::bench::cli
