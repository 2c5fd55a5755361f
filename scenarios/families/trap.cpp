#include "scenarios/families/trap.hpp"

#include <algorithm>
#include <cmath>

namespace pathrace::scenarios {

void wall(OccupancyGrid& grid, Cell from, Cell to) {
  for (int y = std::min(from.y, to.y); y <= std::max(from.y, to.y); ++y) {
    for (int x = std::min(from.x, to.x); x <= std::max(from.x, to.x); ++x) {
      if (grid.contains({x, y})) grid.block({x, y});
    }
  }
}

Sketch turned(const Sketch& sketch, Stream& stream) {
  const int last = sketch.grid.width() - 1;
  const bool mirror_x = stream.below(2) == 1;
  const bool mirror_y = stream.below(2) == 1;
  const bool transpose = stream.below(2) == 1;
  const auto turn = [=](Cell cell) {
    if (mirror_x) cell.x = last - cell.x;
    if (mirror_y) cell.y = last - cell.y;
    return transpose ? Cell{cell.y, cell.x} : cell;
  };
  Sketch result{OccupancyGrid(last + 1, last + 1), turn(sketch.start), turn(sketch.goal)};
  for (int y = 0; y <= last; ++y) {
    for (int x = 0; x <= last; ++x) {
      if (!sketch.grid.is_free({x, y})) result.grid.block(turn({x, y}));
    }
  }
  return result;
}

int share_of(int n, double share) {
  return static_cast<int>(std::floor(n * share + 0.5));
}

Family trap_family(const std::string& name, std::string summary, std::function<Sketch(int, Stream&)> draw) {
  const std::string form = name + "/<n>/<seed>";
  auto make = [form, draw = std::move(draw)](const std::string& id,
                                             const std::vector<std::string_view>& parts) {
    require_parts(id, form, parts, 2);
    const int n = id_number(id, "n", parts[0], least_side, most_side);
    id_number(id, "seed", parts[1], 0, most_seed);
    return certified(id, [&](Stream stream) { return turned(draw(n, stream), stream); });
  };
  return {name, form, std::move(summary), thirty_seeds({name + "/10", name + "/20"}), std::move(make)};
}

}  // namespace pathrace::scenarios
