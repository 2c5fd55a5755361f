#include "core/parameters.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

namespace pathrace {
namespace {

template <typename Number>
bool read_whole(std::string_view text, Number& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc{} && end == text.data() + text.size();
}

}  // namespace

std::int64_t parse_integer(std::string_view name, std::string_view text, std::int64_t low,
                           std::int64_t high) {
  std::int64_t value = 0;
  if (!read_whole(text, value) || value < low || value > high) {
    throw InputError(fmt::format("'{}' must be an integer in {}..{}, got '{}'", name, low, high, text));
  }
  return value;
}

double parse_real(std::string_view name, std::string_view text, double low, double high) {
  double value = 0;
  if (!read_whole(text, value) || !std::isfinite(value) || value < low || value > high) {
    throw InputError(fmt::format("'{}' must be a number in [{}, {}], got '{}'", name, low, high, text));
  }
  return value == 0 ? 0 : value;  // "-0" and "0" are one setting
}

bool parse_boolean(std::string_view name, std::string_view text) {
  if (text == "true") return true;
  if (text == "false") return false;
  throw InputError(fmt::format("'{}' must be true or false, got '{}'", name, text));
}

std::string print_real(double value) {
  return fmt::format("{}", value);
}

void require_known(const ParameterValues& given, const std::vector<ParameterCard>& cards) {
  std::vector<std::string> known;
  for (const ParameterCard& card : cards) known.push_back(card.name);
  for (const auto& entry : given) {
    bool found = false;
    for (const std::string& candidate : known) found = found || candidate == entry.first;
    if (!found) throw InputError(unknown_name("parameter", entry.first, known));
  }
}

void refuse(const ConditionCard& condition, const ParameterValues& complete) {
  std::string values;
  for (const std::string& name : condition.parameters) {
    values += fmt::format("{}{}={}", values.empty() ? "" : " and ", name, complete.at(name));
  }
  const char* const verb = condition.parameters.size() > 1 ? " contradict each other" : "";
  throw InputError(fmt::format("{}{}: {}", values, verb, condition.rule));
}

}  // namespace pathrace
