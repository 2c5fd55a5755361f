// The scenarios of a campaign's map files.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/campaign.hpp"
#include "core/scenario.hpp"
#include "scenarios/left_out.hpp"

namespace pathrace::bench {

/// For each [[scenarios]] of the campaign, what stands for its map file in ids: the file's name without
/// extension; where two files share it, the folder's name, a dash and the file's with extension. Throws
/// InputError when two share even that. Empty for patterns.
std::vector<std::string> names_of_maps(const Campaign& campaign);

struct MapScenarios {
  std::vector<Scenario> scenarios;  ///< drawn ones first, then `pairs`, then `pairs_m`
  std::vector<scenarios::LeftOut> left_out;
};

/// Reads the map and asks its questions. Throws InputError for a map that cannot be read, and one that names
/// the pair (counted from 1) for an end that is off the map or blocked.
MapScenarios scenarios_on_map(const MapChoice& choice, const std::string& name, std::optional<MoveRule> rule);

}  // namespace pathrace::bench
