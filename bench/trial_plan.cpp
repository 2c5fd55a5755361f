#include "bench/trial_plan.hpp"

#include <fmt/format.h>

#include <map>
#include <memory>
#include <set>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "bench/map_scenarios.hpp"
#include "core/error.hpp"
#include "core/hash.hpp"
#include "scenarios/components.hpp"

namespace pathrace::bench {
namespace {

constexpr std::uint64_t most_trials = 10'000'000;  // of one campaign; as rows they take gigabytes
constexpr std::size_t most_combinations = 10'000;  // of one planner's listed values

// One planner per combination of listed values, in the order of the lists.
std::vector<Entrant> entrants_of(const PlannerChoice& choice, const Catalogue& catalogue) {
  std::vector<PlannerCall> calls{parse_call(choice.name)};  // `replan(astar)` is a name, too
  std::vector<std::string> suffixes{""};
  for (const auto& [parameter, values] : choice.values) {
    std::vector<PlannerCall> longer_calls;
    std::vector<std::string> longer_suffixes;
    if (calls.size() * values.size() > most_combinations) {
      throw InputError(fmt::format("planner '{}': its lists of values have more than {} combinations",
                                   choice.name, most_combinations));
    }
    for (std::size_t i = 0; i < calls.size(); ++i) {
      for (const std::string& value : values) {
        longer_calls.push_back(calls[i]);
        longer_calls.back().values[parameter] = value;
        longer_suffixes.push_back(suffixes[i]);
        if (values.size() > 1) {
          longer_suffixes.back() += fmt::format("{}{}={}", suffixes[i].empty() ? ":" : ",", parameter, value);
        }
      }
    }
    calls = std::move(longer_calls);
    suffixes = std::move(longer_suffixes);
  }
  std::vector<Entrant> entrants;
  for (std::size_t i = 0; i < calls.size(); ++i) {
    entrants.push_back(catalogue.enter(calls[i], choice.label.empty() ? "" : choice.label + suffixes[i]));
  }
  return entrants;
}

class Planning {
 public:
  Planning(const Campaign& campaign, const scenarios::Library& library) : library_(library) {
    plan_.campaign = campaign;
  }

  TrialPlan run(const Catalogue& catalogue) {
    std::set<std::string> labels;
    for (const PlannerChoice& choice : plan_.campaign.planners) {
      for (Entrant& entrant : entrants_of(choice, catalogue)) {
        if (!labels.insert(entrant.label).second) {
          throw InputError(
              fmt::format("two planners are called '{}'; give one of them another label", entrant.label));
        }
        plan_.calls.push_back(entrant.full_call());
        plan_.entrants.push_back(std::move(entrant));
      }
      require_few_trials(1);
    }
    if (plan_.campaign.scenarios.empty()) {
      throw InputError(
          fmt::format("campaign '{}' has no [[scenarios]] and no folder of maps", plan_.campaign.name));
    }
    select_scenarios();
    for (const Selection& selection : selected_) {
      for (std::size_t entrant = 0; entrant < plan_.entrants.size(); ++entrant) {
        if (races(entrant, selection.scenario)) add_trials(selection.scenario, entrant, *selection.choice);
      }
    }
    plan_.left_out = scenarios::summary(left_out_);
    if (plan_.groups.empty()) {
      throw InputError(fmt::format("campaign '{}' has no trials{}", plan_.campaign.name,
                                   plan_.left_out.empty() ? "" : "; left out: " + plan_.left_out.front()));
    }
    return std::move(plan_);
  }

 private:
  struct Selection {
    std::size_t scenario;
    const ScenarioChoice* choice;
  };

  // Counted before a scenario is made or a trial listed.
  void require_few_trials(std::uint64_t scenarios) const {
    const std::uint64_t trials = scenarios * plan_.entrants.size() * plan_.campaign.repetitions;
    if (trials <= most_trials) return;
    throw InputError(
        fmt::format("campaign '{}' asks for {} trials ({} scenarios, {} planners, {} repetitions); expected "
                    "at most {}: split it",
                    plan_.campaign.name, trials, scenarios, plan_.entrants.size(), plan_.campaign.repetitions,
                    most_trials));
  }

  void select_scenarios() {
    const std::vector<std::string> map_names = names_of_maps(plan_.campaign);
    for (std::size_t i = 0; i < plan_.campaign.scenarios.size(); ++i) {
      const ScenarioChoice& choice = plan_.campaign.scenarios[i];
      for (const std::string& pattern : choice.select) {
        const std::vector<std::string> ids = library_.select(pattern);
        require_few_trials(selected_.size() + ids.size());
        for (const std::string& id : ids) select_id(id, choice);
      }
      if (!choice.map) continue;
      const MapChoice& map = *choice.map;
      require_few_trials(selected_.size() + map.queries + map.pairs.size() + map.pairs_m.size());
      const MapScenarios found = scenarios_on_map(map, map_names[i], choice.rule);
      for (const Scenario& scenario : found.scenarios) select_own(scenario, choice);
      left_out_.insert(left_out_.end(), found.left_out.begin(), found.left_out.end());
    }
  }

  void select_id(const std::string& id, const ScenarioChoice& choice) {
    const std::string wanted = choice.rule ? fmt::format("{},rule={}", id, name(*choice.rule)) : id;
    if (const auto known = index_of_.find(wanted); known != index_of_.end()) {
      selected_.push_back({known->second, &choice});
      return;
    }
    const bool recorded = id.starts_with("movingai/");
    try {
      const Scenario scenario = library_.load(wanted);
      if (recorded && !has_way(scenario)) return;
      index_of_[wanted] = add_scenario(scenario);
      selected_.push_back({index_of_[wanted], &choice});
    } catch (const InvalidScenario& fault) {
      if (!recorded) throw;  // recorded data may be dirty; no planner answers for it
      left_out_.push_back({"recorded queries that are none", fault.what()});
    }
  }

  void select_own(const Scenario& scenario, const ScenarioChoice& choice) {
    if (has_way(scenario)) selected_.push_back({add_scenario(scenario), &choice});
  }

  // Whether the ends are connected; one more question left out if not.
  bool has_way(const Scenario& scenario) {
    if (scenario.optimum.proven) return scenario.optimum.length.has_value();
    const auto& [grid, rule] = scenario.terrain;
    const auto known = regions_.try_emplace({grid, rule == MoveRule::free}, *grid, rule).first;
    if (known->second.joined(scenario.start, scenario.goal)) return true;
    left_out_.push_back({"questions without a way from start to goal",
                         fmt::format("{}: no way from {},{} to {},{}", scenario.id, scenario.start.x,
                                     scenario.start.y, scenario.goal.x, scenario.goal.y)});
    return false;
  }

  std::size_t add_scenario(const Scenario& scenario) {
    const auto [known, is_new] = index_of_.emplace(scenario.id, plan_.scenarios.size());
    if (!is_new) return known->second;
    plan_.scenarios.push_back(scenario);
    plan_.contents.push_back(content_hash(scenario));
    const auto [first, is_first] = first_with_.emplace(plan_.contents.back(), known->second);
    if (!is_first) {
      plan_.repeated.push_back(fmt::format("{} ({})", scenario.id, plan_.scenarios[first->second].id));
    }
    (scenario.world ? has_worlds_ : has_maps_) = true;
    return known->second;
  }

  // A planner races where it can; one that can race nowhere is recorded as unsupported everywhere.
  bool races(std::size_t entrant, std::size_t scenario) const {
    const bool navigates = plan_.entrants[entrant].card->navigates();
    const bool moves = plan_.scenarios[scenario].world != nullptr;
    return navigates == moves || !(navigates ? has_worlds_ : has_maps_);
  }

  // An id selected twice runs once.
  void add_trials(std::size_t scenario, std::size_t entrant, const ScenarioChoice& choice) {
    const auto number = [](auto index) { return static_cast<std::uint32_t>(index); };
    plan_.groups.push_back(
        {number(scenario), number(entrant), number(&choice - plan_.campaign.scenarios.data())});
    const bool is_new = keys_.insert(plan_.trial(plan_.size() - 1).hash).second;
    if (!is_new) plan_.groups.pop_back();
  }

  const scenarios::Library& library_;
  TrialPlan plan_;
  std::vector<Selection> selected_;
  std::vector<scenarios::LeftOut> left_out_;
  std::map<std::pair<std::shared_ptr<const OccupancyGrid>, bool>, scenarios::Regions> regions_;
  std::unordered_map<std::string, std::size_t> index_of_;
  std::unordered_map<std::uint64_t, std::size_t> first_with_;  // this content
  std::unordered_set<std::uint64_t> keys_;                     // of each group's last trial
  bool has_maps_ = false;
  bool has_worlds_ = false;
};

}  // namespace

const Budget& TrialPlan::budget_of(const TrialGroup& group) const {
  const ScenarioChoice& choice = campaign.scenarios[group.choice];
  if (choice.budget) return *choice.budget;
  return campaign.budget ? *campaign.budget : entrants[group.entrant].card->default_budget;
}

Trial TrialPlan::trial(std::size_t i) const {
  const TrialGroup& group = group_of(i);
  Trial trial{group.scenario, group.entrant, budget_of(group), {}, 0};
  trial.key = {scenarios[group.scenario].id, contents[group.scenario],
               calls[group.entrant],         entrants[group.entrant].version(),
               i % campaign.repetitions,     campaign.seed,
               work_hash(trial.budget)};
  trial.hash = trial.key.hash();
  return trial;
}

std::uint64_t TrialPlan::hash() const {
  Hasher hasher;
  hasher.add(std::string_view(campaign.name));
  for (std::size_t i = 0; i < size(); ++i) {
    const Trial trial = this->trial(i);
    hasher.add(trial.hash).add(std::string_view(entrants[trial.entrant].label));
    hasher.add(trial.budget.wall_s.value_or(0));
  }
  return hasher.value();
}

TrialPlan plan_trials(const Campaign& campaign, const scenarios::Library& library,
                      const Catalogue& catalogue) {
  return Planning(campaign, library).run(catalogue);
}

std::vector<std::string> leave_out_absent(Campaign& campaign, const Catalogue& catalogue) {
  std::vector<std::string> names;
  std::erase_if(campaign.planners, [&](const PlannerChoice& choice) {
    const std::string name = parse_call(choice.name).name;
    if (catalogue.absent(name) == nullptr) return false;
    names.push_back(name);
    return true;
  });
  return names;
}

}  // namespace pathrace::bench
