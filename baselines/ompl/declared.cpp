#include "baselines/ompl/declared.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <optional>
#include <utility>

#include "baselines/ompl/constraints.hpp"

namespace pathrace::baselines {
namespace {

namespace ob = ompl::base;

using Range = std::pair<double, double>;  // first and last

constexpr double widest = 1e6;  // of a parameter without a suggested range

// "first:last" or "first:step:last".
Range suggested_range(const std::string& text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos) return {0, widest};
  return {std::strtod(text.c_str(), nullptr), std::strtod(text.c_str() + text.rfind(':') + 1, nullptr)};
}

DeclaredParameter switch_of(const ob::GenericParamPtr& parameter, const std::string& name) {
  const bool on = parameter->getValue() == "1";
  return {{name, "boolean", on ? "true" : "false", "true|false", "", Source::ours, ""},
          [name](std::string_view text) { return parse_boolean(name, text) ? "true" : "false"; }};
}

DeclaredParameter integer_of(const ob::GenericParamPtr& parameter, const std::string& name) {
  const std::int64_t value = std::strtoll(parameter->getValue().c_str(), nullptr, 10);
  const auto [first, last] = suggested_range(parameter->getRangeSuggestion());
  const std::int64_t low = std::min(static_cast<std::int64_t>(first), value);
  const std::int64_t high = std::max(static_cast<std::int64_t>(last), value);
  return {{name, "integer", std::to_string(value), std::to_string(low) + ".." + std::to_string(high), "",
           Source::ours, ""},
          [=](std::string_view text) { return std::to_string(parse_integer(name, text, low, high)); }};
}

// Infinity has no spelling in a campaign file; a parameter that starts there stays there.
std::optional<DeclaredParameter> real_of(const ob::GenericParamPtr& parameter, const std::string& name,
                                         const std::optional<Range>& accepted) {
  const double value = std::strtod(parameter->getValue().c_str(), nullptr);
  if (!std::isfinite(value)) return std::nullopt;
  const auto [first, last] = accepted.value_or(suggested_range(parameter->getRangeSuggestion()));
  const double low = std::min(first, value);
  const double high = std::max(last, value);
  return DeclaredParameter{
      {name, "real", print_real(value), "[" + print_real(low) + ", " + print_real(high) + "]", "",
       Source::ours, ""},
      [=](std::string_view text) { return print_real(parse_real(name, text, low, high)); }};
}

template <typename... Types>
bool is_one_of(const ob::GenericParamPtr& parameter) {
  return ((dynamic_cast<const ob::SpecificParam<Types>*>(parameter.get()) != nullptr) || ...);
}

std::optional<DeclaredParameter> read(const std::string& name, const ob::GenericParamPtr& parameter,
                                      const std::optional<Range>& accepted) {
  if (is_one_of<bool>(parameter)) return switch_of(parameter, name);
  if (is_one_of<int, long, unsigned, unsigned long>(parameter)) return integer_of(parameter, name);
  if (is_one_of<double, float>(parameter)) return real_of(parameter, name, accepted);
  return std::nullopt;
}

}  // namespace

std::vector<DeclaredParameter> declared_parameters(const ob::ParamSet& parameters) {
  std::vector<DeclaredParameter> declared;
  for (const auto& [name, parameter] : parameters.getParams()) {
    std::optional<DeclaredParameter> found = read(name, parameter, accepted_range(parameters, name));
    if (!found) continue;
    found->card.source = Source::seen;
    found->card.meaning = "as declared by the planner in OMPL";
    declared.push_back(std::move(*found));
  }
  return declared;
}

}  // namespace pathrace::baselines
