#include "bench/trial_plan.hpp"

#include <fmt/format.h>

#include <optional>
#include <set>
#include <unordered_map>
#include <unordered_set>

#include "core/error.hpp"
#include "core/hash.hpp"

namespace pathrace::bench {
namespace {

constexpr std::size_t recorded_queries_per_scen = 2;
constexpr int recorded_most_side = 512;

// One planner per combination of listed values, in the order of the lists.
std::vector<Entrant> entrants_of(const PlannerChoice& choice, const Catalogue& catalogue) {
  std::vector<PlannerCall> calls{parse_call(choice.name)};  // `replan(astar)` is a name, too
  std::vector<std::string> suffixes{""};
  for (const auto& [parameter, values] : choice.values) {
    std::vector<PlannerCall> longer_calls;
    std::vector<std::string> longer_suffixes;
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
    }
    std::vector<Selection> selected;
    for (const ScenarioChoice& choice : plan_.campaign.scenarios) {
      for (const std::string& pattern : choice.select) {
        for (const std::string& id : library_.select(pattern)) {
          if (const auto index = add_scenario(id)) selected.push_back({*index, &choice});
        }
      }
    }
    for (const Selection& selection : selected) {
      for (std::size_t entrant = 0; entrant < plan_.entrants.size(); ++entrant) {
        if (races(entrant, selection.scenario)) add_trials(selection.scenario, entrant, *selection.choice);
      }
    }
    if (plan_.groups.empty())
      throw InputError(fmt::format("campaign '{}' has no trials", plan_.campaign.name));
    return std::move(plan_);
  }

 private:
  struct Selection {
    std::size_t scenario;
    const ScenarioChoice* choice;
  };

  std::optional<std::size_t> add_scenario(const std::string& id) {
    if (const auto known = index_of_.find(id); known != index_of_.end()) return known->second;
    try {
      plan_.scenarios.push_back(library_.load(id));
    } catch (const InvalidScenario& fault) {
      if (!id.starts_with("movingai/")) throw;
      plan_.left_out.emplace_back(fault.what());  // recorded data may be dirty; no planner answers for it
      return std::nullopt;
    }
    const std::size_t index = plan_.scenarios.size() - 1;
    index_of_[id] = index;
    plan_.contents.push_back(content_hash(plan_.scenarios.back()));
    const auto [first, is_new] = first_with_.emplace(plan_.contents.back(), index);
    if (!is_new) plan_.repeated.push_back(fmt::format("{} ({})", id, plan_.scenarios[first->second].id));
    (plan_.scenarios.back().world ? has_worlds_ : has_maps_) = true;
    return index;
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

void add_recorded_maps(Campaign& campaign, const std::filesystem::path& folder,
                       std::vector<std::string>* left_out) {
  campaign.maps = std::filesystem::absolute(folder).lexically_normal();
  const scenarios::Library library(campaign.maps);
  ScenarioChoice choice;
  choice.select = library.spread_recorded(recorded_queries_per_scen, recorded_most_side, left_out);
  if (choice.select.empty())
    throw InputError(fmt::format("{}: holds no query that can be raced", folder.string()));
  campaign.scenarios.push_back(std::move(choice));
}

}  // namespace pathrace::bench
