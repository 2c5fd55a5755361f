#include "scenarios/movingai/folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "core/error.hpp"
#include "core/plain_text.hpp"
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
    throw InputError(fmt::format("{}: is a file; expected a folder of maps", shown(folder)));
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
  std::string name = (stem.extension() == ".map" ? stem.stem() : stem).string();
  require_plain_name(scen.string(), "is named", name);
  return name;
}

// "dao-map" for "dao-scen".
fs::path sibling_of_maps(const fs::path& folder) {
  constexpr std::string_view ending = "-scen";
  const std::string name = folder.filename().string();
  if (!name.ends_with(ending)) return {};
  return folder.parent_path() / (name.substr(0, name.size() - ending.size()) + "-map");
}

// Where the archives put the map of a scen file; empty when it is not there.
fs::path usual_map(const ScenFile& scen, const std::string& name) {
  const fs::path folder = fs::absolute(scen.file).parent_path();
  for (const fs::path& place : {scen.file.parent_path(), sibling_of_maps(folder)}) {
    std::error_code unreachable;
    if (fs::is_regular_file(place / name, unreachable)) return place / name;
  }
  return {};
}

fs::path choose_map(const ScenFile& scen, const std::vector<fs::path>& maps) {
  const std::string wanted = map_file_name(scen.queries.front().map);
  if (fs::path usual = usual_map(scen, wanted); !usual.empty()) return usual;
  std::vector<fs::path> found;
  for (const fs::path& map : maps) {
    if (map.filename().string() == wanted) found.push_back(map);
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

ScenEntry entry_of(const fs::path& file, const std::vector<fs::path>& maps) {
  const ScenFile scen = ScenFile::read(file);
  const fs::path map = choose_map(scen, maps);
  require_same_map(scen, map);
  return {name_of(file), file, map};
}

// Of several with one name the first stays.
std::vector<ScenEntry> with_own_names(const std::vector<ScenEntry>& entries,
                                      std::vector<std::string>& faults) {
  std::vector<ScenEntry> kept;
  for (const ScenEntry& entry : entries) {
    if (kept.empty() || kept.back().name != entry.name) {
      kept.push_back(entry);
      continue;
    }
    faults.push_back(fmt::format("{}: is named '{}', as is {}; expected a name of its own", shown(entry.scen),
                                 printable_name(entry.name), shown(kept.back().scen)));
  }
  return kept;
}

}  // namespace

std::vector<ScenEntry> list_scens(const fs::path& folder, std::vector<std::string>& faults) {
  const Listing listing = sorted_listing(folder);
  std::vector<ScenEntry> entries;
  for (const fs::path& file : listing.scens) {
    try {
      entries.push_back(entry_of(file, listing.maps));
    } catch (const InputError& fault) {
      faults.emplace_back(fault.what());
    }
  }
  std::stable_sort(entries.begin(), entries.end(),
                   [](const ScenEntry& a, const ScenEntry& b) { return a.name < b.name; });
  return with_own_names(entries, faults);
}

std::vector<ScenEntry> find_scens(const fs::path& folder) {
  std::vector<std::string> faults;
  std::vector<ScenEntry> entries = list_scens(folder, faults);
  if (!faults.empty()) throw InputError(faults.front());
  if (entries.empty()) throw InputError(fmt::format("{}: holds no .scen file", shown(folder)));
  return entries;
}

fs::path find_map(const ScenFile& scen, const std::optional<fs::path>& maps) {
  if (maps) return choose_map(scen, sorted_listing(*maps).maps);
  return choose_map(scen, {});
}

std::vector<std::size_t> spread(std::size_t total, std::size_t count) {
  const std::size_t taken = std::min(total, count);
  std::vector<std::size_t> indices;
  indices.reserve(taken);
  for (std::size_t i = 1; i <= taken; ++i) indices.push_back(i * total / taken - 1);
  return indices;
}

}  // namespace pathrace::scenarios
