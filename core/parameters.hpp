// Parameters: an aggregate of settings with defaults, and the schema that says what each field means.
//
// A planner's settings are a plain struct. Its schema lists the fields once; defaults come from the
// struct itself, so there is one place to change them.
//
//   struct Settings { int ants = 50; DeadEnd dead_end = DeadEnd::die; };
//   Schema<Settings>{{
//       integer("ants", &Settings::ants, 1, 100000, "ants", Source::field, "m, ants per iteration"),
//       choice("dead_end", &Settings::dead_end, Source::inferred, "what an ant does when it is stuck"),
//   }}
//
// Values that are each in range may still contradict each other; a schema's conditions say which ones do.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/names.hpp"

namespace pathrace {

/// Where a default comes from: the tags of the algorithms' specification.
enum class Source { paper, field, inferred, literature, computed, seen, ours };

template <>
inline constexpr auto names_of<Source> = std::to_array<std::pair<Source, std::string_view>>({
    {Source::paper, "paper"},            // stated in the paper
    {Source::field, "field"},            // usual value in the field, the paper is silent
    {Source::inferred, "inferred"},      // a reconstruction
    {Source::literature, "literature"},  // general knowledge, not confirmed against the source
    {Source::computed, "computed"},      // computed for this project
    {Source::seen, "seen"},              // seen in public source code or abstracts
    {Source::ours, "ours"},              // this project's own choice
});

/// What the catalogue prints about one parameter. All values are text in their canonical spelling.
struct ParameterCard {
  std::string name;
  std::string type;  ///< "integer", "real", "boolean", or "choice"
  std::string default_value;
  std::string range;  ///< "1..100000", "[0, 1]", or the choices
  std::string unit;   ///< empty when it has none
  Source source = Source::ours;
  std::string meaning;
};

/// What the catalogue prints about a condition on several parameters.
struct ConditionCard {
  std::vector<std::string> parameters;  ///< the names that it ties together
  std::string rule;                     ///< "waypoints_min must be at most waypoints_max"
};

/// Given values by name, as text.
using ParameterValues = std::map<std::string, std::string>;

/// Parsing and printing of single values; each throws InputError with the value and what was expected.
std::int64_t parse_integer(std::string_view name, std::string_view text, std::int64_t low, std::int64_t high);
double parse_real(std::string_view name, std::string_view text, double low, double high);
bool parse_boolean(std::string_view name, std::string_view text);
/// The shortest decimal text that reads back as the same number.
std::string print_real(double value);

template <typename Settings>
struct Field {
  ParameterCard card;
  std::function<void(Settings&, std::string_view)> read;
  std::function<std::string(const Settings&)> print;
};

template <typename Settings, typename Integer>
requires std::is_integral_v<Integer> Field<Settings> integer(std::string name, Integer Settings::*member,
                                                             std::int64_t low, std::int64_t high,
                                                             std::string unit, Source source,
                                                             std::string meaning) {
  Field<Settings> field;
  field.card = {
      name,   "integer",         "", std::to_string(low) + ".." + std::to_string(high), std::move(unit),
      source, std::move(meaning)};
  field.read = [=](Settings& settings, std::string_view text) {
    settings.*member = static_cast<Integer>(parse_integer(name, text, low, high));
  };
  field.print = [=](const Settings& settings) { return std::to_string(settings.*member); };
  return field;
}

template <typename Settings>
Field<Settings> real(std::string name, double Settings::*member, double low, double high, std::string unit,
                     Source source, std::string meaning) {
  Field<Settings> field;
  field.card = {name,
                "real",
                "",
                "[" + print_real(low) + ", " + print_real(high) + "]",
                std::move(unit),
                source,
                std::move(meaning)};
  field.read = [=](Settings& settings, std::string_view text) {
    settings.*member = parse_real(name, text, low, high);
  };
  field.print = [=](const Settings& settings) { return print_real(settings.*member); };
  return field;
}

template <typename Settings>
Field<Settings> boolean(std::string name, bool Settings::*member, Source source, std::string meaning) {
  Field<Settings> field;
  field.card = {name, "boolean", "", "true|false", "", source, std::move(meaning)};
  field.read = [=](Settings& settings, std::string_view text) {
    settings.*member = parse_boolean(name, text);
  };
  field.print = [=](const Settings& settings) { return settings.*member ? "true" : "false"; };
  return field;
}

template <typename Settings, typename Enum>
requires std::is_enum_v<Enum> Field<Settings> choice(std::string name, Enum Settings::*member, Source source,
                                                     std::string meaning) {
  Field<Settings> field;
  std::string range;
  for (const std::string& option : all_names<Enum>()) range += (range.empty() ? "" : "|") + option;
  field.card = {name, "choice", "", range, "", source, std::move(meaning)};
  field.read = [=](Settings& settings, std::string_view text) {
    settings.*member = parse_name<Enum>("value of '" + name + "'", text);
  };
  field.print = [=](const Settings& settings) { return std::string(pathrace::name(settings.*member)); };
  return field;
}

/// A rule that settings keep, whatever their single values.
template <typename Settings>
struct Condition {
  ConditionCard card;
  std::function<bool(const Settings&)> holds;
};

/// `low` must be at most `high`.
template <typename Settings, typename Number>
Condition<Settings> at_most(const std::string& low, Number Settings::*low_member, const std::string& high,
                            Number Settings::*high_member) {
  return {{{low, high}, low + " must be at most " + high},
          [=](const Settings& settings) { return settings.*low_member <= settings.*high_member; }};
}

/// Throws InputError when a given name is no field; names the nearest match.
void require_known(const ParameterValues& given, const std::vector<ParameterCard>& cards);

/// Throws InputError that names the condition's parameters with their values, which `complete` holds.
[[noreturn]] void refuse(const ConditionCard& condition, const ParameterValues& complete);

template <typename Settings>
void require_conditions(const std::vector<Condition<Settings>>& conditions, const Settings& settings,
                        const ParameterValues& complete) {
  for (const Condition<Settings>& condition : conditions) {
    if (!condition.holds(settings)) refuse(condition.card, complete);
  }
}

template <typename Settings>
std::vector<ConditionCard> cards_of(const std::vector<Condition<Settings>>& conditions) {
  std::vector<ConditionCard> cards;
  for (const Condition<Settings>& condition : conditions) cards.push_back(condition.card);
  return cards;
}

template <typename Settings>
class Schema {
 public:
  // NOLINTNEXTLINE(google-explicit-constructor): a list of fields is a schema
  Schema(std::vector<Field<Settings>> fields, std::vector<Condition<Settings>> conditions = {})
      : fields_(std::move(fields)), conditions_(std::move(conditions)) {}

  std::vector<ParameterCard> cards() const {
    std::vector<ParameterCard> cards;
    for (const Field<Settings>& field : fields_) {
      cards.push_back(field.card);
      cards.back().default_value = field.print(Settings{});
    }
    return cards;
  }

  std::vector<ConditionCard> conditions() const { return cards_of(conditions_); }

  /// Settings with the given values over the defaults. Throws InputError for an unknown name, a bad value or
  /// values that contradict each other.
  Settings settings(const ParameterValues& given) const {
    require_known(given, cards());
    Settings settings;
    for (const Field<Settings>& field : fields_) {
      const auto value = given.find(field.card.name);
      if (value != given.end()) field.read(settings, value->second);
    }
    require_conditions(conditions_, settings, print(settings));
    return settings;
  }

  /// Every field in canonical spelling, defaults included.
  ParameterValues print(const Settings& settings) const {
    ParameterValues values;
    for (const Field<Settings>& field : fields_) values[field.card.name] = field.print(settings);
    return values;
  }

 private:
  std::vector<Field<Settings>> fields_;
  std::vector<Condition<Settings>> conditions_;
};

}  // namespace pathrace
