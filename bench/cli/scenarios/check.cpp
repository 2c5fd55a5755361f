// `scenarios check`: is this file sound?
#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "bench/campaign_maps.hpp"
#include "bench/cli/options.hpp"
#include "bench/cli/scenarios/verb.hpp"
#include "bench/roster.hpp"
#include "bench/trial_plan.hpp"
#include "core/error.hpp"
#include "core/plain_text.hpp"
#include "scenarios/library.hpp"
#include "scenarios/map_reader.hpp"
#include "scenarios/movingai/folder.hpp"
#include "scenarios/recorded.hpp"

namespace pathrace::bench::cli {
namespace {

struct CheckOptions {
  std::string file;
  std::string maps;
  MapFileOptions map;

  std::optional<std::filesystem::path> maps_folder() const {
    return maps.empty() ? std::nullopt : std::make_optional<std::filesystem::path>(maps);
  }
};

int check_scen(const CheckOptions& options) {
  const std::filesystem::path file = options.file;
  const scenarios::ScenFile scen = scenarios::ScenFile::read(file);
  const std::filesystem::path map_file = scenarios::find_map(scen, options.maps_folder());
  scenarios::require_same_map(scen, map_file);
  const scenarios::MapFile map = scenarios::MapFile::read(map_file);
  std::size_t bad = 0;
  for (const scenarios::ScenQuery& query : scen.queries) {
    try {
      scenarios::scenario_of("", map, scen, query);
    } catch (const InvalidScenario& fault) {
      ++bad;
      fmt::print("{}\n", escape_controls(fault.what()));
    }
  }
  fmt::print("{}: {} queries on {}, {} bad\n", escape_controls(file.string()), scen.queries.size(),
             escape_controls(map_file.filename().string()), bad);
  return bad > 0 ? something_found : done;
}

int check_map(const CheckOptions& options) {
  const scenarios::GridMap map = scenarios::read_map(options.file, map_options(options.map));
  fmt::print("{}\n", escape_controls(describe_map(options.file, map, options.map)));
  return done;
}

int check_campaign(const CheckOptions& options) {
  Campaign campaign = read_campaign(options.file);
  std::vector<std::string> left_out;
  settle_maps(campaign, options.maps_folder(), maps_folder(""), left_out);
  const TrialPlan plan = plan_trials(campaign, scenarios::Library(campaign.maps), roster());
  left_out.insert(left_out.end(), plan.left_out.begin(), plan.left_out.end());
  for (const std::string& line : left_out) fmt::print(stderr, "left out: {}\n", escape_controls(line));
  fmt::print("{}: a campaign of {} trials, {} planners, {} scenarios\n", escape_controls(options.file),
             plan.size(), plan.entrants.size(), plan.scenarios.size());
  return done;
}

int check_file(const CheckOptions& options) {
  if (Subject{options.file, "", {}}.is_map_file()) return check_map(options);
  const std::string extension = std::filesystem::path(options.file).extension().string();
  if (extension == ".scen") return check_scen(options);
  if (extension == ".toml") return check_campaign(options);
  throw InputError(fmt::format("{}: expected a .scen or .toml file or a map ({})", options.file,
                               fmt::join(scenarios::map_extensions(), " ")));
}

}  // namespace

void add_scenarios_check(CLI::App& parent) {
  auto options = std::make_shared<CheckOptions>();
  CLI::App* verb = add_verb(parent, "check", "validate a map, a .scen file or a campaign", "arena.map.scen",
                            [options] { return check_file(*options); });
  verb->add_option("file", options->file, "the file")->required()->type_name("FILE");
  verb->add_option("--maps", options->maps, "folder of the maps that a .scen file or a campaign is about")
      ->type_name("DIR");
  add_map_file_options(*verb, options->map);
}

}  // namespace pathrace::bench::cli
