#include "scenarios/family.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "core/error.hpp"
#include "core/reference/exact_search.hpp"
#include "scenarios/repeats.hpp"

namespace pathrace::scenarios {

#define PATHRACE_FAMILY(card) Family card();
#include "scenarios/families.def"
#undef PATHRACE_FAMILY

const std::vector<Family>& families() {
  static const std::vector<Family> all = [] {
    std::vector<Family> list = {
#define PATHRACE_FAMILY(card) card(),
#include "scenarios/families.def"
#undef PATHRACE_FAMILY
    };
    std::sort(list.begin(), list.end(), [](const Family& a, const Family& b) { return a.name < b.name; });
    return list;
  }();
  return all;
}

Scenario certified(const std::string& id, const std::function<std::optional<Sketch>(Stream)>& draw,
                   int attempts) {
  const Stream stream = Stream(0).fork("scenario").fork(id);
  for (int attempt = 0; attempt < attempts; ++attempt) {
    std::optional<Sketch> sketch = draw(stream.fork(static_cast<std::uint64_t>(attempt)));
    if (!sketch || sketch->start == sketch->goal) continue;
    Scenario scenario;
    scenario.id = id;
    scenario.terrain = {std::make_shared<const OccupancyGrid>(std::move(sketch->grid)), MoveRule::strict};
    scenario.start = sketch->start;
    scenario.goal = sketch->goal;
    require_valid(scenario);
    scenario.optimum = reference::optimum(scenario.terrain, scenario.start, scenario.goal);
    if (scenario.optimum.length) return scenario;
  }
  throw InvalidScenario(fmt::format("{}: none of {} maps drawn has a way from start to goal", id, attempts));
}

int id_number(std::string_view id, std::string_view what, std::string_view text, int low, int high) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = error == std::errc{} && end == text.data() + text.size();
  const bool canonical = whole && fmt::format("{}", value) == text;  // one question, one id
  if (!canonical || value < low || value > high) {
    throw InputError(
        fmt::format("scenario '{}': {} must be a number in {}..{}, got '{}'", id, what, low, high, text));
  }
  return value;
}

void require_parts(std::string_view id, std::string_view form, const std::vector<std::string_view>& parts,
                   std::size_t count) {
  if (parts.size() != count) throw InputError(fmt::format("scenario '{}': expected the form {}", id, form));
}

std::vector<std::string> thirty_seeds(const std::vector<std::string>& prefixes) {
  std::vector<std::string> ids;
  for (const std::string& prefix : prefixes) {
    for (int seed = 1; seed <= 30; ++seed) {
      std::string id = fmt::format("{}/{}", prefix, seed);
      if (!is_repeat(id)) ids.push_back(std::move(id));
    }
  }
  return ids;
}

}  // namespace pathrace::scenarios
