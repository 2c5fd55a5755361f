// Ids that the library does not list, since they ask the question of an id before them.
//
// On small maps two seeds may draw the same map, start and goal. Every id keeps its question for ever, so a
// repeat can still be loaded and raced by its name; the list, and globs over it, leave it out. Which ids
// repeat is a table, so that listing draws no map; tests prove it against the contents of all listed ids.
#pragma once

#include <string_view>
#include <vector>

namespace pathrace::scenarios {

struct Repeat {
  std::string_view id;
  std::string_view earlier;  ///< the listed id with the same question
};

const std::vector<Repeat>& repeats();

bool is_repeat(std::string_view id);

}  // namespace pathrace::scenarios
