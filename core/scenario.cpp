#include "core/scenario.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/hash.hpp"

namespace pathrace {
namespace {

void require_free(const Scenario& scenario, std::string_view what, Cell cell) {
  const OccupancyGrid& grid = scenario.grid();
  if (!grid.contains(cell)) {
    throw InvalidScenario(fmt::format("{}: {} {},{} is outside the {}x{} map; expected 0,0 to {},{}",
                                      scenario.id, what, cell.x, cell.y, grid.width(), grid.height(),
                                      grid.width() - 1, grid.height() - 1));
  }
  if (!grid.is_free(cell)) {
    throw InvalidScenario(fmt::format("{}: {} {},{} is a blocked cell; expected a free one", scenario.id,
                                      what, cell.x, cell.y));
  }
}

}  // namespace

void require_valid(const Scenario& scenario) {
  require_free(scenario, "start", scenario.start);
  require_free(scenario, "goal", scenario.goal);
}

std::uint64_t content_hash(const Scenario& scenario) {
  if (scenario.world) return scenario.world->hash;
  const OccupancyGrid& grid = scenario.grid();
  Hasher hasher;
  hasher.add(grid.width()).add(grid.height()).add(name(scenario.terrain.rule));
  hasher.add(scenario.start.x).add(scenario.start.y).add(scenario.goal.x).add(scenario.goal.y);
  for (int y = 0; y < grid.height(); ++y) {
    std::uint64_t word = 0;
    for (int x = 0; x < grid.width(); ++x) {
      word |= std::uint64_t{grid.blocked_at(grid.index({x, y})) ? 1U : 0U} << (x & 63);
      if ((x & 63) == 63 || x == grid.width() - 1) {
        hasher.add(word);
        word = 0;
      }
    }
  }
  return hasher.value();
}

}  // namespace pathrace
