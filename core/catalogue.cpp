#include "core/catalogue.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"

namespace pathrace {
namespace {

std::string spell_call(std::string_view name, const ParameterValues& values) {
  std::string text(name);
  char separator = ':';
  for (const auto& [parameter, value] : values) {
    text += fmt::format("{}{}={}", separator, parameter, value);
    separator = ',';
  }
  return text;
}

ParameterValues values_beside_defaults(const PlannerCard& card, ParameterValues values) {
  for (const ParameterCard& parameter : card.parameters) {
    const auto value = values.find(parameter.name);
    if (value != values.end() && value->second == parameter.default_value) values.erase(value);
  }
  return values;
}

std::string usual_label(const PlannerCard& card, const ParameterValues& values) {
  if (card.spell) return card.spell(values);
  return spell_call(card.name, values_beside_defaults(card, values));
}

// Characters before the first of `ends` that stands outside parentheses opened on the way; a closing one ends
// the piece with which its own opened.
std::size_t piece_length(std::string_view text, std::string_view ends) {
  int depth = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '(') ++depth;
    if (text[i] == ')') --depth;
    if (depth == 0 && ends.find(text[i]) != std::string_view::npos) return i;
  }
  return text.size();
}

// "key=value,key=value" into the call.
void read_values(std::string_view text, std::string_view rest, PlannerCall& call) {
  while (true) {
    const std::size_t comma = piece_length(rest, ",");
    const std::string_view item = rest.substr(0, comma);
    const std::size_t equals = item.find('=');
    if (equals == std::string_view::npos || equals == 0) {
      throw InputError(fmt::format("planner call '{}': expected key=value, got '{}'", text, item));
    }
    const std::string key(item.substr(0, equals));
    if (!call.values.emplace(key, item.substr(equals + 1)).second) {
      throw InputError(fmt::format("planner call '{}' gives '{}' twice", text, key));
    }
    if (comma == rest.size()) return;
    rest = rest.substr(comma + 1);
  }
}

}  // namespace

PlannerCard without_parameters(PlannerCard card, Planner planner) {
  card.complete = [](const ParameterValues& given) {
    require_known(given, {});
    return ParameterValues{};
  };
  card.make = [planner = std::move(planner)](const ParameterValues&) { return planner; };
  return card;
}

PlannerCall parse_call(std::string_view text) {
  PlannerCall call;
  std::size_t end = std::min(text.find_first_of(":("), text.size());
  call.name = std::string(text.substr(0, end));
  if (call.name.empty()) throw InputError(fmt::format("planner call '{}' names no planner", text));
  if (end < text.size() && text[end] == '(') {
    const std::size_t close = end + piece_length(text.substr(end), ")");
    if (close == text.size()) throw InputError(fmt::format("planner call '{}': a ')' is missing", text));
    call.values.emplace("planner", text.substr(end + 1, close - end - 1));
    end = close + 1;
  }
  if (end == text.size()) return call;
  if (text[end] != ':') {
    throw InputError(fmt::format("planner call '{}': expected ':', got '{}'", text, text.substr(end)));
  }
  read_values(text, text.substr(end + 1), call);
  return call;
}

std::string Entrant::full_call() const {
  return spell_call(card->name, values);
}

int Entrant::version() const {
  return card->inner ? card->version + card->inner(values).version() - 1 : card->version;
}

bool Entrant::draws() const {
  return card->random || (card->inner && card->inner(values).draws());
}

Catalogue::Catalogue(std::vector<PlannerCard> cards, std::vector<AbsentPlanner> absent)
    : cards_(std::move(cards)), absent_(std::move(absent)) {
  std::sort(cards_.begin(), cards_.end(),
            [](const PlannerCard& a, const PlannerCard& b) { return a.name < b.name; });
}

const PlannerCard& Catalogue::find(std::string_view name) const {
  std::vector<std::string> known;
  for (const PlannerCard& card : cards_) {
    if (card.name == name) return card;
    known.push_back(card.name);
  }
  if (const AbsentPlanner* planner = absent(name)) {
    throw InputError(fmt::format("planner '{}' needs {}", name, planner->needs));
  }
  for (const AbsentPlanner& planner : absent_) known.push_back(planner.name);
  throw InputError(unknown_name("planner", name, known));
}

const AbsentPlanner* Catalogue::absent(std::string_view name) const {
  const auto found = std::find_if(absent_.begin(), absent_.end(),
                                  [name](const AbsentPlanner& planner) { return planner.name == name; });
  return found != absent_.end() ? &*found : nullptr;
}

Entrant Catalogue::enter(const PlannerCall& call, std::string label) const {
  const PlannerCard& card = find(call.name);
  Entrant entrant;
  entrant.card = &card;
  try {
    entrant.values = card.complete(call.values);
  } catch (const InputError& error) {
    throw InputError(fmt::format("planner '{}': {}", call.name, error.what()));
  }
  entrant.label = label.empty() ? usual_label(card, entrant.values) : std::move(label);
  return entrant;
}

}  // namespace pathrace
