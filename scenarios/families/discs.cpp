// Dynamic worlds: `discs/<kind>[,key=value...]/<seed>` (core/world.hpp, scenarios/discs/settings.hpp).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/names.hpp"
#include "scenarios/discs/settings.hpp"
#include "scenarios/discs/worlds.hpp"
#include "scenarios/family.hpp"
#include "scenarios/text.hpp"

namespace pathrace::scenarios {
namespace {

constexpr std::string_view form = "discs/<kind>[,key=value...]/<seed>";
constexpr std::string_view shared_by_some[] = {"goal", "gap", "lane", "inside"};

[[noreturn]] void refuse(const std::string& id, const std::string& what) {
  throw InputError(fmt::format("scenario '{}': {}", id, what));
}

const DiscsKind& kind_of(const std::string& id, std::string_view name) {
  std::vector<std::string> known;
  for (const DiscsKind& kind : discs_kinds()) {
    if (kind.name == name) return kind;
    known.emplace_back(kind.name);
  }
  refuse(id, unknown_name("kind", name, known));
}

ParameterValues read_values(const std::string& id, const std::vector<std::string_view>& pieces) {
  ParameterValues values;
  for (std::size_t i = 1; i < pieces.size(); ++i) {
    const std::size_t equals = pieces[i].find('=');
    if (equals == std::string_view::npos) refuse(id, fmt::format("expected key=value, got '{}'", pieces[i]));
    const std::string key(pieces[i].substr(0, equals));
    if (!values.emplace(key, pieces[i].substr(equals + 1)).second) {
      refuse(id, fmt::format("gives '{}' twice", key));
    }
  }
  return values;
}

bool means_something(const DiscsKind& kind, std::string_view key) {
  const bool special =
      std::find(std::begin(shared_by_some), std::end(shared_by_some), key) != std::end(shared_by_some);
  return !special || std::find(kind.own.begin(), kind.own.end(), key) != kind.own.end();
}

// The id's middle part as it must be written.
std::string canonical_part(const DiscsKind& kind, const ParameterValues& values) {
  std::string part(kind.name);
  for (const ParameterCard& card : discs_schema().cards()) {
    const auto own = kind.defaults.find(card.name);
    const std::string& usual = own != kind.defaults.end() ? own->second : card.default_value;
    const std::string& value = values.at(card.name);
    if (value != usual) part += fmt::format(",{}={}", card.name, value);
  }
  return part;
}

DiscsSettings read_settings(const std::string& id, const DiscsKind& kind, std::string_view part) {
  const ParameterValues given = read_values(id, split_at(part, ','));
  for (const auto& entry : given) {
    if (!means_something(kind, entry.first)) {
      refuse(id, fmt::format("'{}' means nothing to the kind {}", entry.first, kind.name));
    }
  }
  ParameterValues values = given;
  values.insert(kind.defaults.begin(), kind.defaults.end());
  try {
    const DiscsSettings settings = discs_schema().settings(values);
    const std::string canonical = canonical_part(kind, discs_schema().print(settings));
    if (canonical != part) {
      throw InputError(fmt::format("one question has one id; write its middle part as {}", canonical));
    }
    if ((settings.goal == GoalLaw::flee) != (kind.name == "chase")) {
      throw InputError("the goal flees in discs/chase, and only there");
    }
    if (settings.r_min > settings.r_max) throw InputError("r_min is greater than r_max");
    return settings;
  } catch (const InputError& fault) {
    refuse(id, fault.what());
  }
}

Cell cell_of(Point point) {
  return {static_cast<int>(std::floor(point.x)), static_cast<int>(std::floor(point.y))};
}

// The still picture of a world: cell (x, y) covers x..x+1, y..y+1.
void add_picture(Scenario& scenario) {
  const World& world = *scenario.world;
  OccupancyGrid grid(static_cast<int>(world.width), static_cast<int>(world.height));
  scenario.start = cell_of(world.start);
  scenario.goal = cell_of(world.goal);
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x) {
      const Cell cell{x, y};
      if (cell == scenario.start || cell == scenario.goal) continue;
      const bool covered = std::any_of(world.discs.begin(), world.discs.end(), [&](const Disc& disc) {
        return straight_line(disc.centre, {x + 0.5, y + 0.5}) < disc.radius;
      });
      if (covered) grid.block(cell);
    }
  }
  scenario.terrain = {std::make_shared<const OccupancyGrid>(std::move(grid)), MoveRule::strict};
}

Scenario make(const std::string& id, const std::vector<std::string_view>& parts) {
  require_parts(id, form, parts, 2);
  id_number(id, "seed", parts[1], 0, most_seed);
  const DiscsKind& kind = kind_of(id, parts[0].substr(0, parts[0].find(',')));
  Scenario scenario;
  scenario.id = id;
  scenario.world = draw_world(id, kind, read_settings(id, kind, parts[0]));
  add_picture(scenario);
  return scenario;
}

}  // namespace

Family discs_family() {
  std::vector<std::string> prefixes;
  std::string kinds;
  for (const DiscsKind& kind : discs_kinds()) {
    prefixes.push_back(fmt::format("discs/{}", kind.name));
    kinds += fmt::format("{}{}", kinds.empty() ? "" : ", ", kind.name);
  }
  Family family{"discs",
                std::string(form),
                "dynamic worlds of moving discs and a moving goal: " + kinds,
                thirty_seeds(prefixes),
                discs_schema().cards(),
                make};
  family.dynamic = true;
  return family;
}

}  // namespace pathrace::scenarios
