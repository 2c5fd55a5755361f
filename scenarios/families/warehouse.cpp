// Warehouse: racks in rows, aisles between them, a lane around the whole.
//
// Racks are `length` cells long and two deep; some of them, drawn from the seed, are missing, and some
// pallets stand in the aisles where they leave a way. Start and goal: the two corners.
#include <algorithm>

#include "scenarios/families/trap.hpp"
#include "scenarios/generated.hpp"

namespace pathrace::scenarios {
namespace {

constexpr int rack_depth = 2;

struct WarehouseSettings : Placement {
  int aisle = 1;
  int length = 5;
  int missing = 10;
  int pallets = 2;
};

void place_racks(Sketch& sketch, const WarehouseSettings& settings, int n, Stream& stream) {
  const int length = std::min(settings.length, n - 2);
  const int aisle = settings.aisle;
  for (int top = aisle; top + rack_depth <= n - 1; top += rack_depth + aisle) {
    for (int left = aisle; left < n - 1; left += length + aisle) {
      const int right = std::min(left + length, n - 1) - 1;
      if (!stream.chance(settings.missing / 100.0)) {
        wall(sketch.grid, {left, top}, {right, top + rack_depth - 1});
      }
    }
  }
}

void place_pallets(Sketch& sketch, const WarehouseSettings& settings, int n, Stream& stream) {
  const std::size_t cells = static_cast<std::size_t>(n) * static_cast<std::size_t>(n);
  const std::size_t count = cells * static_cast<std::size_t>(settings.pallets) / 100;
  for (std::size_t i = 0; i < count; ++i) {
    const Cell cell{stream.between(0, n - 1), stream.between(0, n - 1)};
    if (cell != sketch.start && cell != sketch.goal) sketch.grid.block(cell);
  }
}

Sketch draw(const WarehouseSettings& settings, int n, Stream& stream) {
  Sketch sketch{OccupancyGrid(n, n), {0, 0}, {n - 1, n - 1}};
  place_racks(sketch, settings, n, stream);
  place_pallets(sketch, settings, n, stream);
  return sketch;
}

}  // namespace

Family warehouse_family() {
  const GeneratedCard card{"warehouse",
                           "racks in rows, aisles between them, pallets in the way",
                           "aisle",
                           Ends::corners,
                           {"20-1", "64-2"}};
  return generated_family<WarehouseSettings>(
      card,
      {integer("aisle", &WarehouseSettings::aisle, 1, 64, "cells", Source::ours, "width of the aisles"),
       integer("length", &WarehouseSettings::length, 1, 256, "cells", Source::ours, "length of a rack"),
       integer("missing", &WarehouseSettings::missing, 0, 100, "%", Source::ours, "racks that are not there"),
       integer("pallets", &WarehouseSettings::pallets, 0, 10, "%", Source::ours,
               "cells where a pallet is put down, racks or not")},
      draw);
}

}  // namespace pathrace::scenarios
