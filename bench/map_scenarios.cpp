#include "bench/map_scenarios.hpp"

#include <fmt/format.h>

#include <map>
#include <set>
#include <utility>

#include "core/error.hpp"
#include "scenarios/map_questions.hpp"
#include "scenarios/under_rule.hpp"

namespace pathrace::bench {
namespace {

namespace fs = std::filesystem;
using scenarios::MapPlace;
using scenarios::MapQuestions;

std::string longer_name(const fs::path& file) {
  return fmt::format("{}-{}", file.parent_path().filename().string(), file.filename().string());
}

// Calls `question(pair)` for each pair; what is wrong with one names it.
template <typename Number, typename Question>
void ask(std::string_view key, const std::vector<std::array<Number, 4>>& pairs, const Question& question) {
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    try {
      question(pairs[i]);
    } catch (const InputError& fault) {
      throw InputError(fmt::format("{} {}: {}", key, i + 1, fault.what()));
    }
  }
}

}  // namespace

std::vector<std::string> names_of_maps(const Campaign& campaign) {
  std::map<std::string, std::set<fs::path>> files_of;
  for (const ScenarioChoice& choice : campaign.scenarios) {
    if (choice.map) files_of[choice.map->file.stem().string()].insert(choice.map->file);
  }
  std::vector<std::string> names;
  std::map<std::string, fs::path> file_of;
  for (const ScenarioChoice& choice : campaign.scenarios) {
    names.emplace_back();
    if (!choice.map) continue;
    const fs::path& file = choice.map->file;
    const std::string stem = file.stem().string();
    names.back() = files_of[stem].size() == 1 ? stem : longer_name(file);
    const fs::path& first = file_of.emplace(names.back(), file).first->second;
    if (first != file) {
      throw InputError(fmt::format("{}: is named '{}', as is {}; expected a name of its own", file.string(),
                                   names.back(), first.string()));
    }
  }
  return names;
}

MapScenarios scenarios_on_map(const MapChoice& choice, const std::string& name,
                              std::optional<MoveRule> rule) {
  const MapQuestions map(choice.file, choice.options, name);
  MapScenarios result;
  if (choice.queries > 0) {
    result.scenarios = map.draw(choice.queries, choice.seed, rule.value_or(MoveRule::strict));
    if (result.scenarios.size() < choice.queries) {
      result.left_out.push_back(
          {"maps with too few questions",
           fmt::format("{}: {} of {} questions; the map has hardly any more", choice.file.string(),
                       choice.queries - result.scenarios.size(), choice.queries)});
    }
  }
  const auto add = [&](const MapPlace& start, const MapPlace& goal) {
    const Scenario scenario = map.between(start, goal);
    result.scenarios.push_back(rule ? scenarios::under_rule(scenario, *rule) : scenario);
  };
  ask("pairs", choice.pairs, [&](const std::array<int, 4>& pair) {
    add(map.at(Cell{pair[0], pair[1]}), map.at(Cell{pair[2], pair[3]}));
  });
  ask("pairs_m", choice.pairs_m, [&](const std::array<double, 4>& pair) {
    add(map.at(scenarios::WorldPoint{pair[0], pair[1]}), map.at(scenarios::WorldPoint{pair[2], pair[3]}));
  });
  return result;
}

}  // namespace pathrace::bench
