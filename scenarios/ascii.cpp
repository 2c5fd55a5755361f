#include "scenarios/ascii.hpp"

#include <algorithm>
#include <ostream>
#include <string>

namespace pathrace::scenarios {
namespace {

constexpr int most_columns = 120;

// The block of cells behind one character.
struct Block {
  int left;
  int top;
  int right;   // exclusive
  int bottom;  // exclusive

  bool holds(Cell cell) const { return cell.x >= left && cell.x < right && cell.y >= top && cell.y < bottom; }
};

char draw(const OccupancyGrid& grid, const Scenario* ends, const Block& block) {
  if (ends != nullptr && block.holds(ends->start)) return 'S';
  if (ends != nullptr && block.holds(ends->goal)) return 'G';
  int blocked = 0;
  for (int y = block.top; y < block.bottom; ++y) {
    for (int x = block.left; x < block.right; ++x) blocked += grid.is_free({x, y}) ? 0 : 1;
  }
  return 2 * blocked >= (block.right - block.left) * (block.bottom - block.top) ? '#' : '.';
}

void print(std::ostream& out, const OccupancyGrid& grid, const Scenario* ends) {
  const int width = grid.width();
  const int height = grid.height();
  const int side = (width + most_columns - 1) / most_columns;
  std::string row;
  for (int y = 0; y < height; y += side) {
    row.clear();
    for (int x = 0; x < width; x += side) {
      row += draw(grid, ends, {x, y, std::min(x + side, width), std::min(y + side, height)});
    }
    out << row << '\n';
  }
}

}  // namespace

void print_ascii(std::ostream& out, const Scenario& scenario) {
  print(out, scenario.grid(), &scenario);
}

void print_ascii(std::ostream& out, const OccupancyGrid& grid) {
  print(out, grid, nullptr);
}

}  // namespace pathrace::scenarios
