#include "bench/gallery_tiles.hpp"

#include <algorithm>

#include "bench/executors.hpp"
#include "bench/roster.hpp"
#include "bench/trial.hpp"
#include "scenarios/library.hpp"

namespace pathrace::bench {
namespace {

constexpr int least_side = 20;  // cells; below, a map shows little of its family,
constexpr int most_side = 32;   // and above, a tile shows little of a map

using Group = std::vector<std::string>;

// Neighbouring ids that agree up to their last slash.
std::vector<Group> groups_of(const std::vector<std::string>& ids) {
  const auto prefix = [](const std::string& id) { return id.substr(0, id.rfind('/')); };
  std::vector<Group> groups;
  for (const std::string& id : ids) {
    if (groups.empty() || prefix(groups.back().front()) != prefix(id)) groups.emplace_back();
    groups.back().push_back(id);
  }
  return groups;
}

int cells_off(const Scenario& scenario) {
  const int longest = std::max(scenario.grid().width(), scenario.grid().height());
  return std::max({0, least_side - longest, longest - most_side});
}

// An exact planner's answer: one of the shortest paths, or none where there is no way.
Answer shortest_path(const Scenario& scenario) {
  const Entrant exact = roster().enter(parse_call("astar"));
  const std::unique_ptr<Executor> executor = make_executor("serial", 1);
  return run_trial(exact, scenario, Referee(scenario.terrain), Budget{}, root_stream(1, scenario.id, 0),
                   *executor)
      .answer;
}

}  // namespace

std::vector<std::string> gallery_ids(const scenarios::Family& family, std::size_t count) {
  const scenarios::Library library;
  std::vector<Group> groups = groups_of(family.library);
  if (groups.empty()) return {};
  std::reverse(groups.begin(), groups.end());
  Group best;
  int least = 0;
  for (Group& group : groups) {
    const int off = cells_off(library.load(group.front()));
    if (!best.empty() && off >= least) continue;
    least = off;
    best = std::move(group);
    if (least == 0) break;
  }
  best.resize(std::min(best.size(), count));
  return best;
}

std::vector<results::Tile> gallery_tiles(std::size_t per_family) {
  const scenarios::Library library;
  std::vector<results::Tile> tiles;
  for (const scenarios::Family& family : scenarios::families()) {
    for (const std::string& id : gallery_ids(family, per_family)) {
      Scenario scenario = library.load(id);
      scenarios::prove(scenario);
      Answer path = shortest_path(scenario);
      tiles.push_back({family.name, family.summary, std::move(scenario), std::move(path)});
    }
  }
  return tiles;
}

}  // namespace pathrace::bench
