#include "baselines/ompl/entry.hpp"

#include <utility>

#include "baselines/ompl/constraints.hpp"
#include "baselines/ompl/declared.hpp"
#include "baselines/ompl/plane.hpp"
#include "baselines/ompl/race.hpp"

namespace pathrace::baselines {
namespace {

const Schema<OmplSettings>& adapter_schema() {
  static const Schema<OmplSettings> schema{{
      real(
          "goal_radius", &OmplSettings::goal_radius, 0, 0.5, "cells", Source::ours,
          "a path may end so far from the goal's centre; the last straight piece, inside the goal's cell, is "
          "added"),
      integer("max_calls", &OmplSettings::max_calls, 0, 1'000'000'000'000, "calls", Source::ours,
              "the search ends when the planner has asked so often whether to stop; 0: never"),
      boolean(
          "simplify", &OmplSettings::simplify, Source::ours,
          "OMPL's path simplification at the end, on what the search leaves of the budget; counted apart"),
  }};
  return schema;
}

// Both kinds of parameters: the adapter's and those that the planner declares.
class Parameters {
 public:
  explicit Parameters(const OmplEntry& entry) : defaults_(entry.defaults) {
    if (entry.aim == Aim::best) defaults_.emplace("goal_radius", "0");
    const OccupancyGrid grid(4, 4);
    Meter meter{Budget{}};
    Inspector inspector(grid, meter);
    declared_ = declared_parameters(entry.make(inspected_plane(inspector))->params());
    conditions_ = conditions_on(declared_);
  }

  std::vector<ParameterCard> cards() const {
    std::vector<ParameterCard> cards = adapter_schema().cards();
    for (const DeclaredParameter& parameter : declared_) cards.push_back(parameter.card);
    for (ParameterCard& card : cards) {
      const auto own = defaults_.find(card.name);
      if (own != defaults_.end()) card.default_value = own->second;
    }
    return cards;
  }

  std::vector<ConditionCard> conditions() const { return cards_of(conditions_); }

  OmplSettings settings(const ParameterValues& given) const {
    return adapter_schema().settings(split(given).first);
  }

  /// What differs from the library's defaults, in the spelling that it reads.
  ParameterValues changed(const ParameterValues& given) const {
    const ParameterValues complete = split(given).second;
    ParameterValues values;
    for (const DeclaredParameter& parameter : declared_) {
      const std::string value = parameter.canonical(complete.at(parameter.card.name));
      if (value == parameter.card.default_value) continue;
      values[parameter.card.name] = value == "true" ? "1" : value == "false" ? "0" : value;
    }
    return values;
  }

  ParameterValues complete(const ParameterValues& given) const {
    require_known(given, cards());
    const auto [adapters, planners] = split(given);
    ParameterValues values = adapter_schema().print(adapter_schema().settings(adapters));
    for (const DeclaredParameter& parameter : declared_) {
      values[parameter.card.name] = parameter.canonical(planners.at(parameter.card.name));
    }
    require_conditions(conditions_, values, values);
    return values;
  }

 private:
  // Given values over the defaults: the adapter's, and the planner's.
  std::pair<ParameterValues, ParameterValues> split(const ParameterValues& given) const {
    ParameterValues adapters = given;
    adapters.insert(defaults_.begin(), defaults_.end());
    ParameterValues planners;
    for (const DeclaredParameter& parameter : declared_) {
      const auto found = adapters.find(parameter.card.name);
      const bool has_value = found != adapters.end();
      planners[parameter.card.name] = has_value ? found->second : parameter.card.default_value;
      if (has_value) adapters.erase(found);
    }
    return {std::move(adapters), std::move(planners)};
  }

  ParameterValues defaults_;
  std::vector<DeclaredParameter> declared_;
  std::vector<Condition<ParameterValues>> conditions_;
};

}  // namespace

PlannerCard ompl_card(const OmplEntry& entry) {
  const auto parameters = std::make_shared<const Parameters>(entry);
  PlannerCard card;
  card.name = entry.name;
  card.kind = Kind::ompl;
  card.track = Track::any_angle;
  card.version = 2;
  card.summary = entry.summary;
  card.source = entry.source;
  card.default_budget.evaluations = 20'000;
  card.parameters = parameters->cards();
  card.conditions = parameters->conditions();
  card.complete = [parameters](const ParameterValues& given) { return parameters->complete(given); };
  card.make = [parameters, make = entry.make](const ParameterValues& given) -> Planner {
    const OmplSettings settings = parameters->settings(given);
    const ParameterValues changed = parameters->changed(given);
    return unprepared([=](const Problem& problem, Context& context) {
      return race(make, settings, changed, problem, context);
    });
  };
  return card;
}

}  // namespace pathrace::baselines
