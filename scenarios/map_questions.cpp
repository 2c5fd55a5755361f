#include "scenarios/map_questions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <utility>

#include "core/error.hpp"
#include "core/names.hpp"
#include "core/reference/distance_field.hpp"
#include "core/stream.hpp"
#include "scenarios/components.hpp"
#include "scenarios/text.hpp"
#include "scenarios/under_rule.hpp"

namespace pathrace::scenarios {
namespace {

using reference::DistanceField;

std::string prefix_of(std::string_view name, const MapOptions& options) {
  std::string prefix = fmt::format("map/{}", printable_name(name));
  if (options.radius > 0) prefix += fmt::format(",radius={}", options.radius);
  if (options.resolution) prefix += fmt::format(",resolution={}", *options.resolution);
  if (options.unknown != MapOptions{}.unknown) {
    prefix += fmt::format(",unknown={}", pathrace::name(options.unknown));
  }
  return prefix;
}

double distance(Point a, Point b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

// The first of the nearest, row by row.
std::optional<Cell> nearest_free_cell(const OccupancyGrid& grid, Point point) {
  double least = std::numeric_limits<double>::infinity();
  std::optional<Cell> nearest;
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x) {
      const double away = distance(centre({x, y}), point);
      if (away >= least || !grid.is_free({x, y})) continue;
      least = away;
      nearest = Cell{x, y};
    }
  }
  return nearest;
}

// The cells at half the greatest distance or more.
std::vector<Cell> far_cells(const DistanceField& field, const std::vector<Cell>& region) {
  double greatest = 0;
  for (const Cell cell : region) greatest = std::max(greatest, field.length(cell)->value());
  std::vector<Cell> cells;
  for (const Cell cell : region) {
    if (field.length(cell)->value() >= greatest / 2) cells.push_back(cell);
  }
  return cells;
}

}  // namespace

MapQuestions::MapQuestions(std::filesystem::path file, const MapOptions& options, std::string_view name)
    : file_(std::move(file)),
      map_(read_map(file_, options)),
      prefix_(prefix_of(name.empty() ? file_.stem().string() : std::string(name), options)) {}

MapPlace MapQuestions::at(Cell cell) const {
  return {fmt::format("{},{}", cell.x, cell.y), cell, centre(cell)};
}

MapPlace MapQuestions::at(WorldPoint place) const {
  const std::optional<Cell> cell = frame().cell_at(place);
  if (!cell) {
    throw InputError(
        fmt::format("{}: {} m, {} m is no point on the map, which is {} m wide and {} m high, with its "
                    "lower left corner at {},{}{}",
                    printable_name(file_.string()), place.x, place.y, frame().metres(frame().width),
                    frame().metres(frame().height), frame().origin.x, frame().origin.y,
                    frame().yaw == 0 ? "" : fmt::format(", turned by {} rad", frame().yaw)));
  }
  return {fmt::format("{} m, {} m (cell {},{})", place.x, place.y, cell->x, cell->y), *cell,
          frame().point_of(place)};
}

void MapQuestions::require_free(std::string_view what, const MapPlace& place,
                                const OccupancyGrid& grid) const {
  if (!grid.contains(place.cell) || grid.is_free(place.cell)) return;
  const bool grown = &grid == map_.grid.get() && map_.drawn->is_free(place.cell);
  std::string help = "the map has no free cell";
  if (const std::optional<Cell> nearest = nearest_free_cell(grid, place.point)) {
    const double edges = distance(centre(*nearest), place.point);
    help = fmt::format(
        "the nearest free cell, {},{}, is {} away", nearest->x, nearest->y,
        map_.measured ? fmt::format("{:.2f} m", frame().metres(edges)) : fmt::format("{:.1f} cells", edges));
  }
  throw InvalidScenario(fmt::format("{}: {} {} {}; {}", printable_name(file_.string()), what, place.asked,
                                    grown ? "lies in a grown obstacle" : "is a blocked cell", help));
}

Scenario MapQuestions::between(const MapPlace& start, const MapPlace& goal) const {
  Scenario scenario;
  scenario.id = printable_name(file_.string());  // so that the faults below name it
  scenario.start = start.cell;
  scenario.goal = goal.cell;
  scenario.terrain.grid = map_.grid_for(start.cell, goal.cell);
  require_free("start", start, scenario.grid());
  require_free("goal", goal, scenario.grid());
  require_valid(scenario);
  scenario.id = fmt::format("{}/{},{}/{},{}", prefix_, start.cell.x, start.cell.y, goal.cell.x, goal.cell.y);
  return scenario;
}

std::vector<Scenario> MapQuestions::draw(std::uint64_t count, std::uint64_t seed, MoveRule rule) const {
  const std::vector<Cell> region = largest_region(*map_.grid);
  if (region.size() < 2) {
    throw InvalidScenario(fmt::format("{}: the largest region has {} free cells; expected 2 or more",
                                      printable_name(file_.string()), region.size()));
  }
  const Stream questions = Stream(seed).fork("question").fork(prefix_);
  std::vector<Scenario> drawn;
  std::set<std::pair<Cell, Cell>> asked;
  for (std::uint64_t k = 0; drawn.size() < count && k < 20 * count; ++k) {
    Stream stream = questions.fork(k);
    const Cell start = region[stream.below(region.size())];
    const DistanceField field({map_.grid, rule}, start);
    const std::vector<Cell> goals = far_cells(field, region);
    const Cell goal = goals[stream.below(goals.size())];
    if (!asked.emplace(start, goal).second) continue;
    Scenario scenario = under_rule(between(at(start), at(goal)), rule);
    scenario.optimum = {true, field.length(goal)};
    drawn.push_back(std::move(scenario));
  }
  return drawn;
}

}  // namespace pathrace::scenarios
