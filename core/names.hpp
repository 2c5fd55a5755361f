// Names: an enum's spelling in files and on the command line, and the nearest match for a misspelt one.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/error.hpp"

namespace pathrace {

/// Specialise for each enum that users spell: `template <> inline constexpr auto names_of<E> =
/// std::to_array<...>`.
template <typename Enum>
inline constexpr std::array<std::pair<Enum, std::string_view>, 0> names_of{};

/// The candidate with the least edit distance to `text`; empty when there are no candidates.
std::string nearest_name(std::string_view text, const std::vector<std::string>& candidates);

/// One line for a name nobody knows: "unknown planner 'asta'; the nearest match is 'astar'".
std::string unknown_name(std::string_view kind, std::string_view text, const std::vector<std::string>& known);

template <typename Enum>
std::string_view name(Enum value) {
  for (const auto& [candidate, text] : names_of<Enum>) {
    if (candidate == value) return text;
  }
  return "?";
}

template <typename Enum>
std::vector<std::string> all_names() {
  std::vector<std::string> names;
  for (const auto& entry : names_of<Enum>) names.emplace_back(entry.second);
  return names;
}

/// Throws InputError naming the nearest match when `text` is no name of the enum.
template <typename Enum>
Enum parse_name(std::string_view kind, std::string_view text) {
  for (const auto& [value, spelling] : names_of<Enum>) {
    if (spelling == text) return value;
  }
  throw InputError(unknown_name(kind, text, all_names<Enum>()));
}

}  // namespace pathrace
