// A campaign: what a TOML file asks for, before anything is looked up.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/budget.hpp"

namespace pathrace::bench {

/// One [[planner]] of the file. A parameter given as a list stands for one planner per value.
struct PlannerChoice {
  std::string name;
  std::string label;  ///< empty: the shortest call that means the same
  std::vector<std::pair<std::string, std::vector<std::string>>> values;
};

/// One [[scenarios]] of the file.
struct ScenarioChoice {
  std::vector<std::string> select;
  std::optional<Budget> budget;  ///< for these scenarios, in place of the campaign's
};

struct Campaign {
  std::string name;
  std::uint64_t seed = 1;
  std::uint64_t repetitions = 1;
  std::optional<Budget> budget;  ///< none: each planner's default budget
  std::vector<PlannerChoice> planners;
  std::vector<ScenarioChoice> scenarios;
  std::optional<std::filesystem::path> maps;  ///< folder of .map and .scen files
};

/// Throws InputError "FILE:LINE:COLUMN: ..." for malformed TOML, unknown keys (with the nearest match), wrong
/// types and values out of range.
Campaign parse_campaign(std::string_view text, const std::string& file);

/// Reads the file; throws InputError when it cannot be read.
Campaign read_campaign(const std::filesystem::path& file);

/// The campaign as TOML; parses back to the same campaign.
std::string to_toml(const Campaign& campaign);

/// A built-in campaign: `starter` or `smoke`. Throws InputError that names the nearest match.
Campaign builtin_campaign(std::string_view name);
std::vector<std::string> builtin_campaigns();

}  // namespace pathrace::bench
