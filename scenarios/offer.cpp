#include "scenarios/offer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "core/error.hpp"
#include "scenarios/components.hpp"
#include "scenarios/map_reader.hpp"
#include "scenarios/ros/map_yaml.hpp"
#include "scenarios/text.hpp"

namespace pathrace::scenarios {
namespace {

namespace fs = std::filesystem;

std::size_t rank_of(const fs::path& file) {
  const std::vector<std::string>& all = map_extensions();
  return static_cast<std::size_t>(std::find(all.begin(), all.end(), file.extension().string()) - all.begin());
}

bool is_yaml(const fs::path& file) {
  return file.extension() == ".yaml" || file.extension() == ".yml";
}

std::vector<fs::path> map_files_below(const fs::path& folder) {
  std::vector<fs::path> files;
  try {
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
      std::error_code unreachable;  // a dangling link is no file
      if (!entry.is_regular_file(unreachable) || rank_of(entry.path()) == map_extensions().size()) continue;
      files.push_back(entry.path());
    }
  } catch (const fs::filesystem_error& failure) {
    throw EnvironmentError(
        fmt::format("{}: cannot be listed: {}", printable_name(folder.string()), failure.code().message()));
  }
  std::sort(files.begin(), files.end());
  return files;
}

// The pictures of the yaml files. A yaml that cannot be read is named elsewhere.
std::set<fs::path> pictures_of(const std::vector<fs::path>& files) {
  std::set<fs::path> pictures;
  for (const fs::path& file : files) {
    if (!is_yaml(file)) continue;
    try {
      pictures.insert(MapYaml::read(file).image.lexically_normal());
    } catch (const InputError&) {
    }
  }
  return pictures;
}

// By place and name without extension: the file that counts.
std::map<fs::path, fs::path> first_of_each_name(const std::vector<fs::path>& files) {
  std::map<fs::path, fs::path> first;
  for (const fs::path& file : files) {
    const auto [known, is_new] = first.emplace(fs::path(file).replace_extension(), file);
    if (!is_new && rank_of(file) < rank_of(known->second)) known->second = file;
  }
  return first;
}

}  // namespace

bool is_too_large(const fs::path& file, const OccupancyGrid& grid, const OfferLimits& limits,
                  std::vector<LeftOut>& left_out) {
  if (std::max(grid.width(), grid.height()) <= limits.max_side) return false;
  left_out.push_back(
      {fmt::format("maps above {} cells a side", limits.max_side),
       fmt::format("{}: {}x{} cells, above {} a side (--max-side, max_side)", printable_name(file.string()),
                   grid.width(), grid.height(), limits.max_side)});
  return true;
}

void offer_map_files(const fs::path& folder, const std::vector<fs::path>& known, const OfferLimits& limits,
                     Offer& offer) {
  const std::vector<fs::path> files = map_files_below(folder);
  const std::set<fs::path> pictures = pictures_of(files);
  const std::map<fs::path, fs::path> first = first_of_each_name(files);
  for (const fs::path& file : files) {
    if (is_yaml(file) || pictures.count(file.lexically_normal()) > 0) continue;
    if (std::find(known.begin(), known.end(), file) != known.end()) continue;
    const fs::path& twin = first.at(fs::path(file).replace_extension());
    if (twin != file) {
      offer.left_out.push_back({"files beside another of the same name",
                                fmt::format("{}: {} beside it counts", printable_name(file.string()),
                                            printable_name(twin.filename().string()))});
      continue;
    }
    try {
      const GridMap map = read_map(file);
      if (is_too_large(file, *map.grid, limits, offer.left_out)) continue;
      if (largest_region(*map.grid).size() < 2) {
        fail_in(printable_name(file.string()), "no two free cells side by side; a question needs two");
      }
      offer.files.push_back(file);
    } catch (const InputError& fault) {
      offer.left_out.push_back({"files that are no maps", fault.what()});
    }
  }
}

}  // namespace pathrace::scenarios
