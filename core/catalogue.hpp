// The catalogue: a card for each planner, and the way from a call like `as:ants=20` to a planner.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/budget.hpp"
#include "core/navigator.hpp"
#include "core/parameters.hpp"
#include "core/planner.hpp"

namespace pathrace {

enum class Kind { aco, ga, pso, search, any_angle, ompl, navigator, floor };

template <>
inline constexpr auto names_of<Kind> = std::to_array<std::pair<Kind, std::string_view>>({
    {Kind::aco, "aco"},
    {Kind::ga, "ga"},
    {Kind::pso, "pso"},
    {Kind::search, "search"},
    {Kind::any_angle, "any_angle"},
    {Kind::ompl, "ompl"},
    {Kind::navigator, "navigator"},
    {Kind::floor, "floor"},
});

struct Entrant;

/// All that is known about a planner without running it.
struct PlannerCard {
  std::string name;
  Kind kind = Kind::search;
  Track track = Track::lattice;
  bool deterministic = true;     ///< the same key gives the same record
  bool random = true;            ///< draws random numbers; if not, every repetition gives the same record
  bool complete_search = false;  ///< finds a way wherever there is one, or spends its budget
  int version = 1;               ///< raised whenever the same key may give another record
  std::string summary;           ///< one line
  std::string source;            ///< paper and equations, or the section of the specification
  Budget default_budget;         ///< used when none is given; the paper's, where it states one
  std::vector<ParameterCard> parameters;
  std::vector<ConditionCard> conditions;  ///< on several parameters at once
  /// Every parameter in canonical spelling, given values over the defaults. Throws InputError.
  std::function<ParameterValues(const ParameterValues&)> complete;
  /// The planner with these settings; empty for navigators. Throws InputError.
  std::function<Planner(const ParameterValues&)> make;
  /// The navigator with these settings; empty for planners of static maps. Throws InputError.
  std::function<NavigatorMaker(const ParameterValues&)> make_navigator;

  /// How tables name a call, given every value; empty: the name with what differs from the defaults.
  std::function<std::string(const ParameterValues&)> spell;

  /// The planner that is a parameter, given every value; empty: no parameter is one.
  std::function<Entrant(const ParameterValues&)> inner;

  bool navigates() const { return static_cast<bool>(make_navigator); }
};

/// Fills in `parameters`, `complete` and `make` from a schema and a factory `Planner(const Settings&)`.
template <typename Settings, typename Factory>
PlannerCard with_parameters(PlannerCard card, const Schema<Settings>& schema, Factory factory) {
  card.parameters = schema.cards();
  card.conditions = schema.conditions();
  card.complete = [schema](const ParameterValues& given) { return schema.print(schema.settings(given)); };
  card.make = [schema, factory](const ParameterValues& given) -> Planner {
    return factory(schema.settings(given));
  };
  return card;
}

/// The same for a navigator: the factory is `std::unique_ptr<Navigator>(const Settings&)`, called for each
/// run. The card races on the track `dynamic`.
template <typename Settings, typename Factory>
PlannerCard with_navigator_parameters(PlannerCard card, const Schema<Settings>& schema, Factory factory) {
  card.track = Track::dynamic;
  card.parameters = schema.cards();
  card.conditions = schema.conditions();
  card.complete = [schema](const ParameterValues& given) { return schema.print(schema.settings(given)); };
  card.make_navigator = [schema, factory](const ParameterValues& given) -> NavigatorMaker {
    return [settings = schema.settings(given), factory]() -> std::unique_ptr<Navigator> {
      return factory(settings);
    };
  };
  return card;
}

/// For planners without parameters.
PlannerCard without_parameters(PlannerCard card, Planner planner);

/// A planner's name with the values a user gave: `as:dead_end=backtrack,ants=20`.
struct PlannerCall {
  std::string name;
  ParameterValues values;
};

/// `NAME`, `NAME:key=value,...`, or with a planner for a parameter, `NAME(PLANNER)`, which says the same as
/// `NAME:planner=(PLANNER)`; commas in parentheses part nothing. Throws InputError on a malformed call.
PlannerCall parse_call(std::string_view text);

/// A card and settled values; everything a trial needs to run a planner.
struct Entrant {
  const PlannerCard* card = nullptr;
  ParameterValues values;  ///< complete, canonical
  std::string
      label;  ///< how tables name it: the given label, or the call with what differs from the defaults

  /// The call with every parameter, defaults included; part of a trial's key.
  std::string full_call() const;
  /// Of the call, and part of a trial's key, too: it rises with the card's version and with that of a planner
  /// that is a parameter. 1 when both are 1.
  int version() const;
  /// True when the planner or one that is a parameter draws random numbers.
  bool draws() const;
};

/// A planner that this build lacks.
struct AbsentPlanner {
  std::string name;
  std::string needs;  ///< what it needs, and how to get it
};

class Catalogue {
 public:
  explicit Catalogue(std::vector<PlannerCard> cards, std::vector<AbsentPlanner> absent = {});

  const std::vector<PlannerCard>& cards() const { return cards_; }
  /// Throws InputError that says what an absent planner needs, or names the nearest match.
  const PlannerCard& find(std::string_view name) const;
  /// Null for planners that are here, and for names that nobody knows.
  const AbsentPlanner* absent(std::string_view name) const;
  /// Settles a call's values; the label defaults to the shortest call that means the same.
  Entrant enter(const PlannerCall& call, std::string label = "") const;

 private:
  std::vector<PlannerCard> cards_;
  std::vector<AbsentPlanner> absent_;
};

}  // namespace pathrace
