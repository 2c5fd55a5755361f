// A folder of MovingAI files: which scen files it holds, each with its map.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace pathrace::scenarios {

struct ScenEntry {
  std::string name;  ///< the scen file's name without `.scen` and `.map`: "arena" for arena.map.scen
  std::filesystem::path scen;
  std::filesystem::path map;
};

/// All scen files below a folder, sorted by name, each with the map that it names: the one beside the scen
/// file, else the one anywhere below the folder. Folders that are symbolic links are not entered. Throws
/// InputError when the folder is missing or without scen files, when a scen file is malformed, when its map
/// is missing or one of several, and when two scen files have one name; EnvironmentError when a folder cannot
/// be listed.
std::vector<ScenEntry> find_scens(const std::filesystem::path& folder);

/// `count` query indices spread evenly over 0..total-1, ascending, the last one included; all of them when
/// count >= total, none when count is 0.
std::vector<std::size_t> spread(std::size_t total, std::size_t count);

}  // namespace pathrace::scenarios
