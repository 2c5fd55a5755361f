#include "scenarios/movingai/writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "core/error.hpp"
#include "scenarios/text.hpp"

namespace pathrace::scenarios {
namespace {

[[noreturn]] void refuse(const Scenario& scenario, std::string_view why) {
  throw InputError(fmt::format("{}: {}", printable_name(scenario.id), why));
}

// What a scen file says without words: the strict rule and a way that exists.
void require_expressible(const Scenario& scenario) {
  if (scenario.terrain.rule != MoveRule::strict) {
    refuse(scenario,
           fmt::format("move rule '{}'; a scen file can hold 'strict' only", name(scenario.terrain.rule)));
  }
  if (!scenario.optimum.proven) refuse(scenario, "no optimum is proven; a scen file needs one");
  if (!scenario.optimum.length) refuse(scenario, "there is no way; a scen file needs an optimum");
}

void require_field(const std::string& map_name) {
  const bool plain = std::none_of(map_name.begin(), map_name.end(), [](char character) {
    return static_cast<unsigned char>(character) < 0x20 || character == 0x7f;
  });
  if (trimmed(map_name).empty() || !plain) {
    throw InputError(fmt::format("map name '{}'; expected a file name", printable(map_name)));
  }
}

void require_written(const std::ostream& out, std::string_view what) {
  if (!out) throw EnvironmentError(fmt::format("the {} could not be written", what));
}

}  // namespace

void write_map(std::ostream& out, const OccupancyGrid& grid) {
  out << fmt::format("type octile\nheight {}\nwidth {}\nmap\n", grid.height(), grid.width());
  for (int y = 0; y < grid.height(); ++y) {
    std::string row(static_cast<std::size_t>(grid.width()), '.');
    for (int x = 0; x < grid.width(); ++x) {
      if (!grid.is_free({x, y})) row[static_cast<std::size_t>(x)] = '@';
    }
    out << row << '\n';
  }
  require_written(out, "map");
}

void write_scen(std::ostream& out, const std::string& map_name, const Scenario& scenario) {
  require_expressible(scenario);
  require_field(map_name);
  const double optimum = scenario.optimum.length->value();
  out << "version 1\n";
  out << fmt::format("{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\t{:.8f}\n", static_cast<int>(std::floor(optimum / 4)),
                     map_name, scenario.grid().width(), scenario.grid().height(), scenario.start.x,
                     scenario.start.y, scenario.goal.x, scenario.goal.y, optimum);
  require_written(out, "scen file");
}

}  // namespace pathrace::scenarios
