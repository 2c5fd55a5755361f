// `scenarios check`: is this file sound?
#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "bench/cli/options.hpp"
#include "bench/cli/scenarios/verb.hpp"
#include "bench/roster.hpp"
#include "bench/trial_plan.hpp"
#include "core/error.hpp"
#include "scenarios/library.hpp"
#include "scenarios/movingai/folder.hpp"
#include "scenarios/recorded.hpp"

namespace pathrace::bench::cli {
namespace {

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

}  // namespace

void add_scenarios_check(CLI::App& parent) {
  auto file = std::make_shared<std::string>();
  CLI::App* verb = add_verb(parent, "check", "validate a .map, .scen or campaign file", "arena.map.scen",
                            [file] { return check_file(*file); });
  verb->add_option("file", *file, "the file")->required()->type_name("FILE");
}

}  // namespace pathrace::bench::cli
