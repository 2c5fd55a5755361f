#include "scenarios/recorded.hpp"

#include <fmt/format.h>

#include <utility>

#include "core/error.hpp"
#include "core/names.hpp"
#include "scenarios/family.hpp"
#include "scenarios/text.hpp"

namespace pathrace::scenarios {
namespace {

std::string id_of(const std::string& scen, std::size_t index) {
  return fmt::format("movingai/{}/{}", scen, index + 1);
}

}  // namespace

Scenario scenario_of(const std::string& id, const MapFile& map, const ScenFile& scen,
                     const ScenQuery& query) {
  const std::string where = fmt::format("{}:{}", scen.file.string(), query.line);
  if (query.width != map.width() || query.height != map.height()) {
    throw InvalidScenario(fmt::format("{}: says the map has {}x{} cells, but it has {}x{}", where,
                                      query.width, query.height, map.width(), map.height()));
  }
  Scenario scenario;
  scenario.id = where;  // so that the faults below name the file and the line
  scenario.start = query.start;
  scenario.goal = query.goal;
  scenario.terrain = {map.grid_for(query.start, query.goal), MoveRule::strict};
  require_valid(scenario);
  scenario.id = id;
  return scenario;
}

RecordedQueries::RecordedQueries(std::filesystem::path folder)
    : folder_(std::move(folder)), entries_(list_scens(folder_, faults_)) {}

RecordedQueries::Opened RecordedQueries::open(const ScenEntry& entry) {
  const std::lock_guard lock(mutex_);
  auto map = maps_.find(entry.map);
  if (map == maps_.end()) map = maps_.emplace(entry.map, MapFile::read(entry.map)).first;
  auto scen = scens_.find(entry.scen);
  if (scen == scens_.end()) {
    scen = scens_.emplace(entry.scen, ScenFile::read(entry.scen)).first;
    require_same_map(scen->second, entry.map);
  }
  return {&map->second, &scen->second};
}

RecordedQueries::Opened RecordedQueries::open(const std::string& scen) {
  std::vector<std::string> known;
  for (const ScenEntry& entry : entries_) {
    if (entry.name == scen) return open(entry);
    known.push_back(entry.name);
  }
  if (!faults_.empty()) throw InputError(faults_.front());
  require_any();
  throw InputError(unknown_name("scen file", scen, known));
}

void RecordedQueries::require_any() const {
  if (entries_.empty()) {
    throw InputError(fmt::format("{}: holds no .scen file", printable_name(folder_.string())));
  }
}

std::vector<std::string> RecordedQueries::list() {
  if (!faults_.empty()) throw InputError(faults_.front());
  require_any();
  std::vector<std::string> ids;
  for (const ScenEntry& entry : entries_) {
    const std::size_t total = open(entry).scen->queries.size();
    for (std::size_t index = 0; index < total; ++index) ids.push_back(id_of(entry.name, index));
  }
  return ids;
}

Scenario RecordedQueries::load(const std::string& id, const std::string& scen, const std::string& k) {
  const Opened opened = open(scen);
  const int total = static_cast<int>(opened.scen->queries.size());
  const int index = id_number(id, "the query's number", k, 1, total) - 1;
  return scenario_of(id, *opened.map, *opened.scen, opened.scen->queries[static_cast<std::size_t>(index)]);
}

void RecordedQueries::offer(const OfferLimits& limits, Offer& offer) {
  for (const std::string& fault : faults_)
    offer.left_out.push_back({"scen files that cannot be read", fault});
  for (const ScenEntry& entry : entries_) {
    try {
      const Opened opened = open(entry);
      if (is_too_large(entry.map, *opened.map->ground(), limits, offer.left_out)) continue;
      for (const std::size_t index : spread(opened.scen->queries.size(), limits.queries_per_map)) {
        offer.ids.push_back(id_of(entry.name, index));
      }
    } catch (const InputError& fault) {
      offer.left_out.push_back({"maps that cannot be raced on", fault.what()});
    }
  }
}

std::set<std::filesystem::path> RecordedQueries::maps() const {
  std::set<std::filesystem::path> maps;
  for (const ScenEntry& entry : entries_) maps.insert(entry.map);
  return maps;
}

}  // namespace pathrace::scenarios
