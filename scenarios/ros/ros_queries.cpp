#include "scenarios/ros/ros_queries.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "core/names.hpp"
#include "core/plain_text.hpp"
#include "core/stream.hpp"
#include "scenarios/components.hpp"
#include "scenarios/family.hpp"
#include "scenarios/ros/map_yaml.hpp"
#include "scenarios/text.hpp"

namespace pathrace::scenarios {
namespace {

namespace fs = std::filesystem;

bool has_yaml_extension(const fs::path& file) {
  return file.extension() == ".yaml" || file.extension() == ".yml";
}

std::vector<fs::path> yamls_below(const fs::path& folder) {
  std::vector<fs::path> files;
  try {
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
      std::error_code unreachable;  // a dangling link is no file
      if (!has_yaml_extension(entry.path()) || !entry.is_regular_file(unreachable)) continue;
      if (may_be_ros_map(entry.path())) files.push_back(entry.path());
    }
  } catch (const fs::filesystem_error& failure) {
    throw EnvironmentError(
        fmt::format("{}: cannot be listed: {}", printable_name(folder.string()), failure.code().message()));
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<RosMapEntry> named(const std::vector<fs::path>& files) {
  std::map<std::string, int> uses;
  for (const fs::path& file : files) ++uses[file.stem().string()];
  std::vector<RosMapEntry> entries;
  for (const fs::path& file : files) {
    const std::string stem = file.stem().string();
    const std::string above = file.parent_path().filename().string();
    const std::string name = uses[stem] == 1 ? stem : fmt::format("{}-{}", above, stem);
    require_plain_name(file.string(), "is named", name);
    entries.push_back({name, file});
  }
  std::stable_sort(entries.begin(), entries.end(),
                   [](const RosMapEntry& a, const RosMapEntry& b) { return a.name < b.name; });
  return entries;
}

bool lies_below(const fs::path& file, const fs::path& folder) {
  const fs::path relative = fs::relative(file, folder);
  return !relative.empty() && *relative.begin() != "..";
}

void require_distinct_names(const std::vector<RosMapEntry>& entries) {
  const auto twin =
      std::adjacent_find(entries.begin(), entries.end(),
                         [](const RosMapEntry& a, const RosMapEntry& b) { return a.name == b.name; });
  if (twin == entries.end()) return;
  throw InputError(fmt::format("{}: is named '{}', as is {}; expected a name of its own",
                               printable_name((twin + 1)->yaml.string()), printable_name(twin->name),
                               printable_name(twin->yaml.string())));
}

}  // namespace

std::vector<RosMapEntry> find_ros_maps(const fs::path& folder) {
  std::vector<fs::path> files = yamls_below(folder);
  std::error_code missing;
  const fs::path neighbour = fs::weakly_canonical(folder, missing).parent_path() / "ros";
  if (files.empty() && fs::is_directory(neighbour, missing)) files = yamls_below(neighbour);
  std::vector<RosMapEntry> entries = named(files);
  require_distinct_names(entries);
  return entries;
}

const std::vector<RosMapEntry>& RosQueries::entries() {
  if (!listed_) entries_ = find_ros_maps(folder_);
  listed_ = true;
  return entries_;
}

const RosQueries::Opened& RosQueries::open(const std::string& map) {
  const std::lock_guard lock(mutex_);
  const auto opened = maps_.find(map);
  if (opened != maps_.end()) return opened->second;
  std::vector<std::string> known;
  for (const RosMapEntry& entry : entries()) {
    known.push_back(entry.name);
    if (entry.name != map) continue;
    auto grid = std::make_shared<const OccupancyGrid>(read_ros_map(entry.yaml).grid(UnknownPolicy::blocked));
    std::vector<Cell> region = largest_region(*grid);
    return maps_.emplace(map, Opened{std::move(grid), std::move(region)}).first->second;
  }
  if (known.empty()) throw InputError(fmt::format("{}: holds no yaml of a ROS map", folder_.string()));
  throw InputError(unknown_name("ROS map", map, known));
}

Scenario RosQueries::load(const std::string& id, const std::string& map, const std::string& k) {
  id_number(id, "the question's number", k, 1, most_seed);
  const Opened& opened = open(map);
  const std::size_t cells = opened.region.size();
  if (cells < 2) {
    throw InvalidScenario(
        fmt::format("{}: the largest region has {} free cells; expected 2 or more", id, cells));
  }
  Stream stream = Stream(0).fork("scenario").fork(id);
  const std::size_t start = stream.below(cells);
  const std::size_t other = stream.below(cells - 1);
  Scenario scenario;
  scenario.id = id;
  scenario.terrain = {opened.grid, MoveRule::strict};
  scenario.start = opened.region[start];
  scenario.goal = opened.region[other < start ? other : other + 1];
  require_valid(scenario);
  return scenario;
}

void RosQueries::offer(const OfferLimits& limits, Offer& offer) {
  std::vector<RosMapEntry> maps;
  {
    const std::lock_guard lock(mutex_);
    maps = entries();
  }
  for (const RosMapEntry& map : maps) {
    if (!lies_below(map.yaml, folder_)) continue;
    try {
      const Opened& opened = open(map.name);
      if (is_too_large(map.yaml, *opened.grid, limits, offer.left_out)) continue;
      for (std::uint64_t k = 1; k <= limits.queries_per_map; ++k) {
        const std::string id = fmt::format("ros/{}/{}", map.name, k);
        load(id, map.name, std::to_string(k));
        offer.ids.push_back(id);
      }
    } catch (const InputError& fault) {
      offer.left_out.push_back({"maps that cannot be raced on", fault.what()});
    }
  }
}

std::vector<std::string> RosQueries::list() {
  std::vector<std::string> prefixes;
  {
    const std::lock_guard lock(mutex_);
    for (const RosMapEntry& entry : entries()) prefixes.push_back("ros/" + entry.name);
  }
  return thirty_seeds(prefixes);
}

}  // namespace pathrace::scenarios
