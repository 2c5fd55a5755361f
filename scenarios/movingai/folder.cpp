#include "scenarios/movingai/folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "core/error.hpp"
#include "scenarios/movingai/scen_file.hpp"
#include "scenarios/text.hpp"

namespace pathrace::scenarios {
namespace {

namespace fs = std::filesystem;

struct Listing {
  std::vector<fs::path> scens;
  std::vector<fs::path> maps;
};

std::string shown(const fs::path& path) {
  return printable_name(path.string());
}

Listing list(const fs::path& folder) {
  Listing listing;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    std::error_code unreachable;  // a dangling link is no file
    if (!entry.is_regular_file(unreachable)) continue;
    if (entry.path().extension() == ".scen") listing.scens.push_back(entry.path());
    if (entry.path().extension() == ".map") listing.maps.push_back(entry.path());
  }
  return listing;
}

// The order in which a file system lists is nobody's business.
Listing sorted_listing(const fs::path& folder) {
  std::error_code error;
  const fs::file_status status = fs::status(folder, error);
  if (status.type() == fs::file_type::not_found) {
    throw InputError(fmt::format("{}: no such folder", shown(folder)));
  }
  if (!error && !fs::is_directory(status)) {
    throw InputError(fmt::format("{}: is a file; expected a folder of .scen files", shown(folder)));
  }
  try {
    Listing listing = list(folder);
    std::sort(listing.scens.begin(), listing.scens.end());
    std::sort(listing.maps.begin(), listing.maps.end());
    return listing;
  } catch (const fs::filesystem_error& failure) {
    throw EnvironmentError(fmt::format("{}: cannot be listed: {}", shown(folder), failure.code().message()));
  }
}

std::string name_of(const fs::path& scen) {
  const fs::path stem = scen.stem();
  return (stem.extension() == ".map" ? stem.stem() : stem).string();
}

fs::path find_map(const ScenFile& scen, const std::vector<fs::path>& maps) {
  const std::string wanted = map_file_name(scen.queries.front().map);
  std::vector<fs::path> found;
  for (const fs::path& map : maps) {
    if (map.filename().string() != wanted) continue;
    if (map.parent_path() == scen.file.parent_path()) return map;
    found.push_back(map);
  }
  const int line = scen.queries.front().line;
  if (found.empty()) {
    fail_at(scen.file.string(), line,
            fmt::format("names map '{}', and there is none in the folder", printable(wanted)));
  }
  if (found.size() > 1) {
    fail_at(scen.file.string(), line,
            fmt::format("names map '{}', which is {} as well as {}", printable(wanted), shown(found[0]),
                        shown(found[1])));
  }
  return found.front();
}

void require_distinct_names(const std::vector<ScenEntry>& entries) {
  const auto twin =
      std::adjacent_find(entries.begin(), entries.end(),
                         [](const ScenEntry& a, const ScenEntry& b) { return a.name == b.name; });
  if (twin != entries.end()) {
    throw InputError(fmt::format("{}: is named '{}', as is {}; expected a name of its own",
                                 shown((twin + 1)->scen), printable_name(twin->name), shown(twin->scen)));
  }
}

}  // namespace

std::vector<ScenEntry> find_scens(const fs::path& folder) {
  const Listing listing = sorted_listing(folder);
  if (listing.scens.empty()) throw InputError(fmt::format("{}: holds no .scen file", shown(folder)));
  std::vector<ScenEntry> entries;
  for (const fs::path& file : listing.scens) {
    const ScenFile scen = ScenFile::read(file);
    const fs::path map = find_map(scen, listing.maps);
    require_same_map(scen, map);
    entries.push_back({name_of(file), file, map});
  }
  std::stable_sort(entries.begin(), entries.end(),
                   [](const ScenEntry& a, const ScenEntry& b) { return a.name < b.name; });
  require_distinct_names(entries);
  return entries;
}

std::vector<std::size_t> spread(std::size_t total, std::size_t count) {
  const std::size_t taken = std::min(total, count);
  std::vector<std::size_t> indices;
  indices.reserve(taken);
  for (std::size_t i = 1; i <= taken; ++i) indices.push_back(i * total / taken - 1);
  return indices;
}

}  // namespace pathrace::scenarios
