// A folder of MovingAI files: which scen files it holds, each with its map.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "scenarios/movingai/scen_file.hpp"

namespace pathrace::scenarios {

struct ScenEntry {
  std::string name;  ///< the scen file's name without `.scen` and `.map`: "arena" for arena.map.scen
  std::filesystem::path scen;
  std::filesystem::path map;
};

/// All scen files below a folder, sorted by name, each with the map that it names: the one beside the scen
/// file, else the one in the folder `x-map` beside the scen's folder `x-scen`, as the archives unpack, else
/// the only one anywhere below the folder. Folders that are symbolic links are not entered.
///
/// A scen file that is malformed, whose map is missing or one of several, or that has another's name is left
/// out, and why is added to `faults`. Throws InputError when the folder is missing, EnvironmentError when it
/// cannot be listed.
std::vector<ScenEntry> list_scens(const std::filesystem::path& folder, std::vector<std::string>& faults);

/// The same; throws InputError for the first fault, and for a folder without scen files.
std::vector<ScenEntry> find_scens(const std::filesystem::path& folder);

/// The map of one scen file: beside it or in the folder `x-map` beside its folder `x-scen`, else below the
/// folder `maps`, if one is given. Throws InputError when there is none, or one of several.
std::filesystem::path find_map(const ScenFile& scen, const std::optional<std::filesystem::path>& maps);

/// `count` query indices spread evenly over 0..total-1, ascending, the last one included; all of them when
/// count >= total, none when count is 0.
std::vector<std::size_t> spread(std::size_t total, std::size_t count);

}  // namespace pathrace::scenarios
