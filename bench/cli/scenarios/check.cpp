// `scenarios check`: is this file sound?
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "bench/cli/options.hpp"
#include "bench/cli/scenarios/verb.hpp"
#include "bench/roster.hpp"
#include "bench/trial_plan.hpp"
#include "core/error.hpp"
#include "scenarios/library.hpp"
#include "scenarios/map_reader.hpp"
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

int check_map(const std::filesystem::path& file, const MapFileOptions& options) {
  const scenarios::GridMap map = scenarios::read_map(file, map_options(options));
  const scenarios::MapFrame& frame = map.frame;
  fmt::print("{}: a map of {}x{} cells, {} free", file.string(), frame.width, frame.height,
             map.grid->free_cells());
  if (map.water != nullptr) {
    fmt::print(" on the ground, {} of water", map.water->free_cells());
  } else {
    if (map.unknown_cells) fmt::print(", {} unknown (taken as {})", *map.unknown_cells, options.unknown);
    fmt::print(", resolution {}, origin {},{}, yaw {}", frame.resolution, frame.origin.x, frame.origin.y,
               frame.yaw);
  }
  fmt::print("\n");
  return done;
}

bool is_known(const std::string& extension) {
  const std::vector<std::string>& maps = scenarios::map_extensions();
  return std::find(maps.begin(), maps.end(), extension) != maps.end();
}

int check_file(const std::filesystem::path& file, const MapFileOptions& map) {
  const std::string extension = file.extension().string();
  if (is_known(extension)) return check_map(file, map);
  if (extension == ".scen") return check_scen(file);
  if (extension == ".toml") {
    const Campaign campaign = read_campaign(file);
    const scenarios::Library library(campaign.maps ? campaign.maps : maps_folder(""));
    const TrialPlan plan = plan_trials(campaign, library, roster());
    fmt::print("{}: a campaign of {} trials, {} planners, {} scenarios\n", file.string(), plan.size(),
               plan.entrants.size(), plan.scenarios.size());
    return done;
  }
  throw InputError(fmt::format("{}: expected a .scen or .toml file or a map ({})", file.string(),
                               fmt::join(scenarios::map_extensions(), " ")));
}

}  // namespace

void add_scenarios_check(CLI::App& parent) {
  auto file = std::make_shared<std::string>();
  auto map = std::make_shared<MapFileOptions>();
  CLI::App* verb = add_verb(parent, "check", "validate a map, a .scen file or a campaign", "arena.map.scen",
                            [file, map] { return check_file(*file, *map); });
  verb->add_option("file", *file, "the file")->required()->type_name("FILE");
  add_map_file_options(*verb, *map);
}

}  // namespace pathrace::bench::cli
