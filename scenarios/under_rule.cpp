#include "scenarios/under_rule.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/names.hpp"

namespace pathrace::scenarios {
namespace {

constexpr std::string_view mark = ",rule=";

}  // namespace

Scenario under_rule(Scenario scenario, MoveRule rule) {
  if (scenario.world) {
    throw InputError(
        fmt::format("scenario '{}': a rule of '{}', and there are no moves of cells in a dynamic world",
                    scenario.id, name(rule)));
  }
  if (rule == scenario.terrain.rule) return scenario;
  scenario.id = fmt::format("{}{}{}", scenario.id, mark, name(rule));
  scenario.terrain.rule = rule;
  scenario.optimum = {};
  return scenario;
}

std::pair<std::string, std::optional<MoveRule>> split_rule(std::string_view id) {
  const std::size_t at = id.rfind(mark);
  if (at == std::string_view::npos || id.find('/', at) != std::string_view::npos)
    return {std::string(id), {}};
  return {std::string(id.substr(0, at)), parse_name<MoveRule>("move rule", id.substr(at + mark.size()))};
}

}  // namespace pathrace::scenarios
