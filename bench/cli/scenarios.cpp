// `scenarios`: what the library holds, how it looks, and whether a file is sound.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

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

bool Subject::is_map_file() const {
  const std::vector<std::string>& known = scenarios::map_extensions();
  return std::find(known.begin(), known.end(), std::filesystem::path(id).extension().string()) != known.end();
}

void add_subject_options(CLI::App& verb, Subject& subject) {
  verb.add_option("id", subject.id, "a scenario, or a map file")->required()->type_name("ID|FILE");
  verb.add_option("--maps", subject.maps, "folder of recorded maps, for movingai/... and ros/... scenarios")
      ->type_name("DIR");
  add_map_file_options(verb, subject.map);
}

std::string describe_map(const std::string& file, const scenarios::GridMap& map,
                         const MapFileOptions& options) {
  const scenarios::MapFrame& frame = map.frame;
  std::string text = fmt::format("{}: a map of {}x{} cells, {} free", file, frame.width, frame.height,
                                 map.grid->free_cells());
  if (map.water != nullptr) {
    return text + fmt::format(" on the ground, {} of water", map.water->free_cells());
  }
  if (map.unknown_cells)
    text += fmt::format(", {} unknown (taken as {})", *map.unknown_cells, options.unknown);
  return text + fmt::format(", resolution {}, origin {},{}, yaw {}", frame.resolution, frame.origin.x,
                            frame.origin.y, frame.yaw);
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
