// Baffle trap: walls across the whole map, open by turns at the bottom and at the top.
//
// The way is a serpentine; half of its lanes lead away from the goal. Start and goal lie in opposite corners.
#include <algorithm>

#include "scenarios/families/trap.hpp"

namespace pathrace::scenarios {
namespace {

Sketch draw(const TrapSettings& settings, int n, Stream& stream) {
  Sketch sketch{OccupancyGrid(n, n), {0, 0}, {n - 1, n - 1}};
  const int walls = number_of(settings.nesting, 2, 5, (n - 1) / 2, stream);
  const int mouth = length_of(settings.mouth, n, 5, 20, 1, n - 2, stream);
  const bool first_opens_below = stream.below(2) == 1;
  const int slack = n - 1 - 2 * walls;  // columns beyond one wall and one lane each
  std::vector<int> shifts;
  for (int i = 0; i < walls; ++i) shifts.push_back(stream.between(0, slack));
  std::sort(shifts.begin(), shifts.end());
  for (int i = 0; i < walls; ++i) {
    const int x = 1 + 2 * i + shifts[static_cast<std::size_t>(i)];
    const bool opens_below = (i % 2 == 0) == first_opens_below;
    wall(sketch.grid, {x, opens_below ? 0 : mouth}, {x, opens_below ? n - 1 - mouth : n - 1});
  }
  return sketch;
}

}  // namespace

Family trap_baffle_family() {
  return trap_family("trap-baffle", "walls across the map, open by turns at either end", TrapAxis::diagonal,
                     {trap_mouth(90, "width of the openings"), trap_nesting(1000, "number of walls")}, draw);
}

}  // namespace pathrace::scenarios
