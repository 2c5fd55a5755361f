// Scattered single cells: no two blocked cells share an edge, many touch at a corner.
//
// The maps on which the move rules differ most: the diagonal step between two cells that touch at a corner is
// legal under `free` alone, so a chain of them is a wall under every other rule.
#include <algorithm>

#include "scenarios/generated.hpp"

namespace pathrace::scenarios {
namespace {

struct ScatterSettings : Placement {
  int percent = 20;
  int contact = 50;
};

bool is_blocked(const OccupancyGrid& grid, Cell cell) {
  return grid.contains(cell) && !grid.is_free(cell);
}

bool may_block(const OccupancyGrid& grid, Cell cell) {
  return grid.is_free(cell) && !is_blocked(grid, {cell.x - 1, cell.y}) &&
         !is_blocked(grid, {cell.x + 1, cell.y}) && !is_blocked(grid, {cell.x, cell.y - 1}) &&
         !is_blocked(grid, {cell.x, cell.y + 1});
}

// Next to a corner of a cell blocked before, or anywhere.
Cell candidate(const ScatterSettings& settings, const std::vector<Cell>& blocked, int n, Stream& stream) {
  if (!blocked.empty() && stream.chance(settings.contact / 100.0)) {
    const Cell cell = blocked[stream.below(blocked.size())];
    return {cell.x + (stream.below(2) == 1 ? 1 : -1), cell.y + (stream.below(2) == 1 ? 1 : -1)};
  }
  return {stream.between(0, n - 1), stream.between(0, n - 1)};
}

Sketch draw(const ScatterSettings& settings, int n, Stream& stream) {
  Sketch sketch{OccupancyGrid(n, n), {}, {}};
  const std::size_t wanted =
      static_cast<std::size_t>(settings.percent) * static_cast<std::size_t>(n * n) / 100;
  std::vector<Cell> blocked;
  blocked.reserve(wanted);
  const std::size_t tries = 8 * static_cast<std::size_t>(n) * static_cast<std::size_t>(n);
  for (std::size_t i = 0; i < tries && blocked.size() < wanted; ++i) {
    const Cell cell = candidate(settings, blocked, n, stream);
    if (!may_block(sketch.grid, cell)) continue;
    sketch.grid.block(cell);
    blocked.push_back(cell);
  }
  return sketch;
}

}  // namespace

Family scatter_family() {
  const GeneratedCard card{"scatter",
                           "single blocked cells, many of which touch at a corner",
                           "percent",
                           Ends::corners,
                           {"20-20", "64-20"}};
  return generated_family<ScatterSettings>(
      card,
      {integer("percent", &ScatterSettings::percent, 0, 35, "%", Source::ours,
               "blocked cells, as many as fit"),
       integer("contact", &ScatterSettings::contact, 0, 100, "%", Source::ours,
               "share of the cells that are set to touch another at a corner")},
      draw);
}

}  // namespace pathrace::scenarios
