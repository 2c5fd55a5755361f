// City: blocks of houses of different sizes between streets, with squares and courtyards.
//
// Streets run across the whole map; their distances vary by half of the usual block around it. A block is
// built up, empty (a square), has a courtyard that is open to one street, or has lost a corner.
#include <algorithm>

#include "scenarios/families/trap.hpp"
#include "scenarios/generated.hpp"

namespace pathrace::scenarios {
namespace {

struct CitySettings : Placement {
  int block = 5;
  int street = 1;
  int squares = 10;
  int courtyards = 20;
};

struct Span {
  int first;
  int last;
  int size() const { return last - first + 1; }
};

// The blocks along one axis; a street before each of them, and what is left at the end.
std::vector<Span> blocks_along(int n, const CitySettings& settings, Stream& stream) {
  std::vector<Span> spans;
  int at = settings.street;
  while (at < n) {
    const int size =
        stream.between(std::max(1, settings.block - settings.block / 2), settings.block + settings.block / 2);
    const int last = std::min(at + size, n - settings.street) - 1;
    if (last < at) break;
    spans.push_back({at, last});
    at = last + 1 + settings.street;
  }
  return spans;
}

void clear(OccupancyGrid& grid, Cell first, Cell last) {
  for (int y = first.y; y <= last.y; ++y) {
    for (int x = first.x; x <= last.x; ++x) grid.clear({x, y});
  }
}

// The inside of a block, and a gate from its middle to the street below or to the right.
void open_courtyard(OccupancyGrid& grid, Span columns, Span rows, Stream& stream) {
  clear(grid, {columns.first + 1, rows.first + 1}, {columns.last - 1, rows.last - 1});
  const Cell middle{(columns.first + columns.last) / 2, (rows.first + rows.last) / 2};
  if (stream.below(2) == 1) {
    clear(grid, {middle.x, rows.last}, {middle.x, rows.last});
  } else {
    clear(grid, {columns.last, middle.y}, {columns.last, middle.y});
  }
}

// A quarter of the block, at one of its corners.
void cut_corner(OccupancyGrid& grid, Span columns, Span rows, Stream& stream) {
  const int width = columns.size() / 2;
  const int height = rows.size() / 2;
  const int left = stream.below(2) == 1 ? columns.first : columns.last - width + 1;
  const int top = stream.below(2) == 1 ? rows.first : rows.last - height + 1;
  clear(grid, {left, top}, {left + width - 1, top + height - 1});
}

void build_block(OccupancyGrid& grid, Span columns, Span rows, const CitySettings& settings, Stream& stream) {
  if (stream.chance(settings.squares / 100.0)) return;
  wall(grid, {columns.first, rows.first}, {columns.last, rows.last});
  const bool wide = columns.size() >= 3 && rows.size() >= 3;
  if (wide && stream.chance(settings.courtyards / 100.0)) return open_courtyard(grid, columns, rows, stream);
  if (stream.below(4) == 0) cut_corner(grid, columns, rows, stream);
}

Sketch draw(const CitySettings& settings, int n, Stream& stream) {
  Sketch sketch{OccupancyGrid(n, n), {}, {}};
  const std::vector<Span> columns = blocks_along(n, settings, stream);
  const std::vector<Span> rows = blocks_along(n, settings, stream);
  for (const Span row : rows) {
    for (const Span column : columns) build_block(sketch.grid, column, row, settings, stream);
  }
  return sketch;
}

}  // namespace

Family city_family() {
  const GeneratedCard card{
      "city", "blocks of houses, streets, squares and courtyards", "block", Ends::corners, {"20-4", "64-8"}};
  return generated_family<CitySettings>(
      card,
      {integer("block", &CitySettings::block, 1, 512, "cells", Source::ours, "usual side of a block"),
       integer("street", &CitySettings::street, 1, 64, "cells", Source::ours, "width of the streets"),
       integer("squares", &CitySettings::squares, 0, 100, "%", Source::ours, "blocks that are not built up"),
       integer("courtyards", &CitySettings::courtyards, 0, 100, "%", Source::ours,
               "blocks that have an open courtyard")},
      draw);
}

}  // namespace pathrace::scenarios
