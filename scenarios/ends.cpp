#include "scenarios/ends.hpp"

#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>

#include "core/reference/distance_field.hpp"
#include "scenarios/components.hpp"

namespace pathrace::scenarios {
namespace {

using reference::DistanceField;

// Of the cells in scan order the first with the least squared distance.
Cell nearest_to(const std::vector<Cell>& cells, Cell corner) {
  std::int64_t least = std::numeric_limits<std::int64_t>::max();
  Cell best{};
  for (const Cell cell : cells) {
    const std::int64_t dx = cell.x - corner.x;
    const std::int64_t dy = cell.y - corner.y;
    if (dx * dx + dy * dy >= least) continue;
    least = dx * dx + dy * dy;
    best = cell;
  }
  return best;
}

// The cell with the greatest distance; the first in scan order where several have it.
Cell farthest(const DistanceField& field, const std::vector<Cell>& cells) {
  Cell best = cells.front();
  for (const Cell cell : cells) {
    if (*field.length(cell) > *field.length(best)) best = cell;
  }
  return best;
}

void place_far(Sketch& sketch, const Terrain& terrain, const std::vector<Cell>& cells, Cell from) {
  LatticeLength longest;
  while (true) {
    const DistanceField field(terrain, from);
    const Cell to = farthest(field, cells);
    if (*field.length(to) <= longest) return;
    longest = *field.length(to);
    sketch.start = from;
    sketch.goal = to;
    from = to;
  }
}

void place_random(Sketch& sketch, const Terrain& terrain, const std::vector<Cell>& cells, int difficulty,
                  Stream& stream) {
  constexpr double tolerance = 0.05;
  sketch.start = cells[stream.below(cells.size())];
  const DistanceField field(terrain, sketch.start);
  const double greatest = field.length(farthest(field, cells))->value();
  const auto miss = [&](Cell cell) {
    return std::fabs(field.length(cell)->value() / greatest - difficulty / 100.0);
  };
  std::vector<Cell> candidates;
  Cell nearest = farthest(field, cells);
  for (const Cell cell : cells) {
    if (cell == sketch.start) continue;
    if (miss(cell) <= tolerance) candidates.push_back(cell);
    if (miss(cell) < miss(nearest)) nearest = cell;
  }
  sketch.goal = candidates.empty() ? nearest : candidates[stream.below(candidates.size())];
}

}  // namespace

std::vector<Field<Placement>> placement_fields() {
  return {
      choice("ends", &Placement::ends, Source::ours,
             "start and goal: own (the family's rule), corners, far (each farthest from the other), random"),
      integer("difficulty", &Placement::difficulty, 1, 100, "%", Source::ours,
              "with ends=random: distance of the goal in percent of the start's greatest distance"),
  };
}

bool place_ends(Sketch& sketch, Ends rule, int difficulty, Stream& stream) {
  const std::vector<Cell> cells = largest_region(sketch.grid);
  if (cells.size() < 2) return false;
  if (rule == Ends::corners) {
    sketch.start = nearest_to(cells, {0, 0});
    sketch.goal = nearest_to(cells, {sketch.grid.width() - 1, sketch.grid.height() - 1});
    return sketch.start != sketch.goal;
  }
  // The searches only look at the grid while it lives here.
  const Terrain terrain{std::shared_ptr<const OccupancyGrid>(std::shared_ptr<void>(), &sketch.grid),
                        MoveRule::strict};
  if (rule == Ends::far) {
    place_far(sketch, terrain, cells, cells[stream.below(cells.size())]);
  } else {
    place_random(sketch, terrain, cells, difficulty, stream);
  }
  return true;
}

}  // namespace pathrace::scenarios
