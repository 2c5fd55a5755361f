#include "scenarios/sets.hpp"

#include "core/hash.hpp"
#include "core/names.hpp"

namespace pathrace::scenarios {

const std::vector<ScenarioSet>& sets() {
  static const std::vector<ScenarioSet> all = {
#define PATHRACE_SET(name, summary, ...) ScenarioSet{name, summary, {__VA_ARGS__}},
#include "scenarios/sets.def"
#undef PATHRACE_SET
  };
  return all;
}

const ScenarioSet& find_set(std::string_view name) {
  std::vector<std::string> known;
  for (const ScenarioSet& set : sets()) {
    if (set.name == name) return set;
    known.push_back(set.name);
  }
  throw InputError(unknown_name("set", name, known));
}

std::vector<std::string> ids_of(const ScenarioSet& set, const Library& library) {
  std::vector<std::string> ids;
  for (const std::string& pattern : set.patterns) {
    for (std::string& id : library.select(pattern)) ids.push_back(std::move(id));
  }
  return ids;
}

std::uint64_t hash_of(const std::vector<std::string>& ids, const Library& library) {
  Hasher hasher;
  for (const std::string& id : ids) hasher.add(std::string_view(id)).add(content_hash(library.load(id)));
  return hasher.value();
}

}  // namespace pathrace::scenarios
