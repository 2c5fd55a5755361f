#include "scenarios/inflate.hpp"

#include <fmt/format.h>

#include "core/distance_transform.hpp"
#include "core/error.hpp"

namespace pathrace::scenarios {

OccupancyGrid inflated(const OccupancyGrid& grid, double radius) {
  if (!(radius >= 0)) throw InputError(fmt::format("a radius of {}; expected at least 0", radius));
  OccupancyGrid grown = grid;
  if (radius < 1) return grown;  // no other cell's centre is that near
  const double reach = radius * radius * (1 + 1e-9);
  const DistanceTransform distance(grid, Border::open);
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x) {
      if (static_cast<double>(distance.squared({x, y})) <= reach) grown.block({x, y});
    }
  }
  return grown;
}

}  // namespace pathrace::scenarios
