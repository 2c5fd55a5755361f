// A campaign: what a TOML file asks for, before anything is looked up.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/budget.hpp"
#include "core/move_rule.hpp"
#include "scenarios/map_reader.hpp"
#include "scenarios/offer.hpp"

namespace pathrace::bench {

/// One [[planner]] of the file. A parameter given as a list stands for one planner per value.
struct PlannerChoice {
  std::string name;
  std::string label;  ///< empty: the shortest call that means the same
  std::vector<std::pair<std::string, std::vector<std::string>>> values;
};

/// A map file and the questions on it: `queries` drawn from `seed`, then those between given ends.
struct MapChoice {
  std::filesystem::path file;
  scenarios::MapOptions options;
  std::uint64_t queries = 0;
  std::uint64_t seed = 1;
  std::vector<std::array<int, 4>> pairs;       ///< start x, y and goal x, y, in cells
  std::vector<std::array<double, 4>> pairs_m;  ///< the same in metres of the map's frame
};

/// One [[scenarios]] of the file: patterns of the library, or a map.
struct ScenarioChoice {
  std::vector<std::string> select;
  std::optional<MapChoice> map;
  std::optional<MoveRule> rule;  ///< in place of the scenarios' own
  std::optional<Budget> budget;  ///< for these scenarios, in place of the campaign's
};

struct Campaign {
  std::string name;
  std::uint64_t seed = 1;
  std::uint64_t repetitions = 1;
  std::optional<Budget> budget;  ///< none: each planner's default budget
  std::vector<PlannerChoice> planners;
  std::vector<ScenarioChoice> scenarios;
  /// Folder of recorded maps; a campaign that names one and selects nothing from it races on all of them.
  std::optional<std::filesystem::path> maps;
  scenarios::OfferLimits limits;  ///< on what the folder offers
};

/// Throws InputError "FILE:LINE:COLUMN: ..." for malformed TOML, unknown keys (with the nearest match), wrong
/// types and values out of range.
Campaign parse_campaign(std::string_view text, const std::string& file);

/// Reads the file, whose paths of maps count from its folder; throws InputError when it cannot be read.
Campaign read_campaign(const std::filesystem::path& file);

/// The campaign as TOML; parses back to the same campaign.
std::string to_toml(const Campaign& campaign);

/// A built-in campaign: `starter` or `smoke`. Throws InputError that names the nearest match.
Campaign builtin_campaign(std::string_view name);
std::vector<std::string> builtin_campaigns();

}  // namespace pathrace::bench
