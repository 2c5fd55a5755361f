// Named sets of scenarios, so that a paper can cite "pathrace library v1, set traps".
//
// A set is a list of ids and, through the bits of its scenarios, one hash: whoever gets the same hash has the
// same maps, starts and goals. What a set holds changes only with the library's version.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "scenarios/library.hpp"

namespace pathrace::scenarios {

/// Raised whenever an id gives another scenario, or a set another list.
inline constexpr int library_version = 1;

/// A pattern `set/<name>` stands for a set.
inline constexpr std::string_view set_prefix = "set/";

struct ScenarioSet {
  std::string name;
  std::string summary;                ///< one line
  std::vector<std::string> patterns;  ///< as in a campaign's `select`
};

const std::vector<ScenarioSet>& sets();

/// Throws InputError that names the nearest match.
const ScenarioSet& find_set(std::string_view name);

/// The ids of a set, in order.
std::vector<std::string> ids_of(const ScenarioSet& set, const Library& library);

/// Over the ids and the content of their scenarios, in order.
std::uint64_t hash_of(const std::vector<std::string>& ids, const Library& library);

}  // namespace pathrace::scenarios
