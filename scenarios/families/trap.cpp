#include "scenarios/families/trap.hpp"

#include <algorithm>
#include <cmath>

namespace pathrace::scenarios {
namespace {

template <typename Turn>
Sketch moved(const Sketch& sketch, const Turn& turn) {
  const int n = sketch.grid.width();
  Sketch result{OccupancyGrid(n, n), turn(sketch.start), turn(sketch.goal)};
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x < n; ++x) {
      if (!sketch.grid.is_free({x, y})) result.grid.block(turn(Cell{x, y}));
    }
  }
  return result;
}

// Quarter turns clockwise, after mirroring along the axis; both from the stream where the id is silent.
Sketch turned(const Sketch& sketch, TrapAxis axis, Facing facing, Stream& stream) {
  const int last = sketch.grid.width() - 1;
  const bool mirror = stream.below(2) == 1;
  const int drawn = stream.between(0, 3);
  const int quarters =
      facing == Facing::any ? drawn : static_cast<int>(facing) - static_cast<int>(Facing::east);
  return moved(sketch, [=](Cell cell) {
    if (mirror) cell = axis == TrapAxis::row ? Cell{cell.x, last - cell.y} : Cell{cell.y, cell.x};
    for (int i = 0; i < quarters; ++i) cell = {last - cell.y, cell.x};
    return cell;
  });
}

}  // namespace

Field<TrapSettings> trap_depth(int most_percent, const std::string& meaning) {
  return integer("depth", &TrapSettings::depth, 0, most_percent, "% of n", Source::ours,
                 meaning + "; 0: drawn from the seed");
}

Field<TrapSettings> trap_mouth(int most_percent, const std::string& meaning) {
  return integer("mouth", &TrapSettings::mouth, 0, most_percent, "% of n", Source::ours,
                 meaning + "; 0: drawn from the seed");
}

Field<TrapSettings> trap_nesting(int most, const std::string& meaning) {
  return integer("nesting", &TrapSettings::nesting, 0, most, "", Source::ours,
                 meaning + ", as many as fit; 0: drawn from the seed");
}

Family trap_family(const std::string& name, const std::string& summary, TrapAxis axis,
                   std::vector<Field<TrapSettings>> fields,
                   std::function<Sketch(const TrapSettings&, int, Stream&)> draw) {
  fields.push_back(
      choice("facing", &TrapSettings::facing, Source::ours,
             axis == TrapAxis::row
                 ? "where the goal lies as seen from the start; any: drawn from the seed"
                 : "the goal lies to the south-east for east, south-west for south, and so on; any: "
                   "drawn from the seed"));
  const GeneratedCard card{name, summary, "", Ends::own, {"10", "20"}};
  return generated_family<TrapSettings>(
      card, std::move(fields),
      [axis, draw = std::move(draw)](const TrapSettings& settings, int n, Stream& stream) {
        return turned(draw(settings, n, stream), axis, settings.facing, stream);
      });
}

void wall(OccupancyGrid& grid, Cell from, Cell to) {
  const int left = std::max(0, std::min(from.x, to.x));
  const int right = std::min(grid.width() - 1, std::max(from.x, to.x));
  const int top = std::max(0, std::min(from.y, to.y));
  const int bottom = std::min(grid.height() - 1, std::max(from.y, to.y));
  for (int y = top; y <= bottom; ++y) {
    for (int x = left; x <= right; ++x) grid.block({x, y});
  }
}

int share_of(int n, double share) {
  return static_cast<int>(std::floor(n * share + 0.5));
}

int length_of(int percent, int n, int low, int high, int least, int most, Stream& stream) {
  const int given = share_of(n, percent / 100.0);
  const int shortest = std::clamp(share_of(n, low / 100.0), least, std::max(least, most));
  const int longest = std::clamp(share_of(n, high / 100.0), shortest, std::max(shortest, most));
  return percent > 0 ? std::clamp(given, least, std::max(least, most)) : stream.between(shortest, longest);
}

int number_of(int given, int low, int high, int most, Stream& stream) {
  const int top = std::clamp(high, 1, std::max(1, most));
  const int number = given > 0 ? given : stream.between(std::min(low, top), top);
  return std::clamp(number, 1, std::max(1, most));
}

}  // namespace pathrace::scenarios
