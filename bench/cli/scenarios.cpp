// `scenarios`: what the library holds, how it looks, and whether a file is sound.
#include <fmt/format.h>

#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>

#include "bench/cli/command.hpp"
#include "bench/cli/options.hpp"
#include "bench/roster.hpp"
#include "bench/run_folder.hpp"
#include "bench/trial_plan.hpp"
#include "core/error.hpp"
#include "core/hash.hpp"
#include "results/svg.hpp"
#include "scenarios/ascii.hpp"
#include "scenarios/library.hpp"
#include "scenarios/movingai/folder.hpp"
#include "scenarios/movingai/writer.hpp"
#include "scenarios/recorded.hpp"

namespace pathrace::bench::cli {
namespace {

using Json = nlohmann::ordered_json;

struct ScenariosCommand {
  std::string maps;
  std::string family;
  bool json = false;
  std::string id;
  std::string format;
  std::string out;
  std::string file;
};

scenarios::Library library_for(const ScenariosCommand& command) {
  return scenarios::Library(maps_folder(command.maps));
}

Scenario proven(const ScenariosCommand& command) {
  Scenario scenario = library_for(command).load(command.id);
  scenarios::prove(scenario);
  return scenario;
}

std::string print_optimum(const Scenario& scenario) {
  return scenario.optimum.length ? fmt::format("{:.4f}", scenario.optimum.length->value()) : "no way";
}

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

int list_scenarios(const ScenariosCommand& command) {
  const scenarios::Library library = library_for(command);
  std::vector<std::string> ids;
  for (const std::string& id : library.list()) {
    if (below(id, command.family)) ids.push_back(id);
  }
  if (ids.empty()) {
    throw InputError(fmt::format("--family: nothing in the library begins with '{}'", command.family));
  }
  Json array = Json::array();
  if (!command.json) fmt::print("{:<24} {:>9} {:<7} {:>10}  hash\n", "id", "size", "rule", "optimum");
  for (const std::string& id : ids) {
    const Scenario scenario = library.load(id);
    if (command.json) {
      array.push_back(object_of(scenario));
      continue;
    }
    const std::string size = fmt::format("{}x{}", scenario.grid().width(), scenario.grid().height());
    fmt::print("{:<24} {:>9} {:<7} {:>10}  {}\n", id, size, name(scenario.terrain.rule),
               print_optimum(scenario), hex(content_hash(scenario)));
  }
  if (command.json) fmt::print("{}\n", array.dump(1));
  return done;
}

int show_scenario(const ScenariosCommand& command) {
  const Scenario scenario = proven(command);
  fmt::print("{}: {}x{} cells, {} free, rule {}, start {},{}, goal {},{}, optimum {}\n", scenario.id,
             scenario.grid().width(), scenario.grid().height(), scenario.grid().free_cells(),
             name(scenario.terrain.rule), scenario.start.x, scenario.start.y, scenario.goal.x,
             scenario.goal.y, print_optimum(scenario));
  scenarios::print_ascii(std::cout, scenario);
  return done;
}

std::string file_name_of(const std::string& id) {
  std::string file = id;
  for (char& c : file) {
    if (c == '/') c = '-';
  }
  return file + ".map";
}

int export_scenario(const ScenariosCommand& command) {
  const Scenario scenario = proven(command);
  std::ostringstream text;
  if (command.format == "map") {
    scenarios::write_map(text, scenario.grid());
  } else if (command.format == "scen") {
    scenarios::write_scen(text, file_name_of(scenario.id), scenario);
  } else if (command.format == "svg") {
    results::write_svg(text, scenario, std::nullopt, scenario.id);
  } else {
    throw InputError(
        fmt::format("--format: {}", unknown_name("format", command.format, {"map", "scen", "svg"})));
  }
  if (command.out.empty()) {
    std::cout << text.str();
  } else {
    write_file(command.out, text.str());
  }
  return done;
}

int check_scen(const std::filesystem::path& file) {
  const scenarios::ScenFile scen = scenarios::ScenFile::read(file);
  if (scen.queries.empty()) throw InputError(fmt::format("{}: holds no query", file.string()));
  const auto map_file = file.parent_path() / std::filesystem::path(scen.queries.front().map).filename();
  scenarios::require_same_map(scen, map_file);
  const scenarios::MapFile map = scenarios::MapFile::read(map_file);
  std::size_t bad = 0;
  for (const scenarios::ScenQuery& query : scen.queries) {
    try {
      scenarios::scenario_of("", map, scen, query);
    } catch (const InvalidScenario& fault) {
      ++bad;
      fmt::print("{}\n", fault.what());
    }
  }
  fmt::print("{}: {} queries on {}, {} bad\n", file.string(), scen.queries.size(),
             map_file.filename().string(), bad);
  return bad > 0 ? something_found : done;
}

int check_file(const std::filesystem::path& file) {
  const std::string extension = file.extension().string();
  if (extension == ".map") {
    const scenarios::MapFile map = scenarios::MapFile::read(file);
    fmt::print("{}: a map of {}x{} cells, {} free on the ground, {} of water\n", file.string(), map.width(),
               map.height(), map.ground()->free_cells(), map.water()->free_cells());
    return done;
  }
  if (extension == ".scen") return check_scen(file);
  if (extension == ".toml") {
    const Campaign campaign = read_campaign(file);
    const scenarios::Library library(campaign.maps ? campaign.maps : maps_folder(""));
    const TrialPlan plan = plan_trials(campaign, library, roster());
    fmt::print("{}: a campaign of {} trials, {} planners, {} scenarios\n", file.string(), plan.trials.size(),
               plan.entrants.size(), plan.scenarios.size());
    return done;
  }
  throw InputError(fmt::format("{}: expected a .map, .scen or .toml file", file.string()));
}

CLI::App* add_verb(CLI::App& parent, const std::string& verb, const std::string& summary,
                   const std::string& example, const std::shared_ptr<ScenariosCommand>& command,
                   int (*body)(const ScenariosCommand&)) {
  return add_command(parent, verb, summary, "pathrace scenarios " + verb + " " + example,
                     [command, body] { return body(*command); });
}

}  // namespace

void add_scenarios(CLI::App& app) {
  auto command = std::make_shared<ScenariosCommand>();
  CLI::App* parent = app.add_subcommand("scenarios", "list, show, export or check scenarios");
  parent->require_subcommand(1);
  parent->footer("Example:\n  pathrace scenarios show trap-u/20/3");

  CLI::App* list = add_verb(*parent, "list", "the library's list, with proven optima and hashes",
                            "--family trap-l/20", command, list_scenarios);
  list->add_option("--family", command->family, "only ids below this prefix")->type_name("PREFIX");
  list->add_flag("--json", command->json, "print a JSON array");

  CLI::App* show =
      add_verb(*parent, "show", "draw a scenario on the terminal", "trap-u/20/3", command, show_scenario);
  CLI::App* out = add_verb(*parent, "export", "write a scenario as a file",
                           "dense/20-20/7 --format map -o dense.map", command, export_scenario);
  out->add_option("--format", command->format, "map, scen or svg")->required()->type_name("FORMAT");
  out->add_option("-o,--out", command->out, "the file (default: standard output)")->type_name("FILE");
  for (CLI::App* verb : {show, out}) {
    verb->add_option("id", command->id, "a scenario")->required()->type_name("ID");
    verb->add_option("--maps", command->maps, "folder of recorded maps, for movingai/... scenarios")
        ->type_name("DIR");
  }

  CLI::App* check = add_verb(*parent, "check", "validate a .map, .scen or campaign file", "arena.map.scen",
                             command, [](const ScenariosCommand& c) { return check_file(c.file); });
  check->add_option("file", command->file, "the file")->required()->type_name("FILE");
}

}  // namespace pathrace::bench::cli
