// Cells and points: where things are.
//
// Column x grows to the right, row y grows downwards, (0,0) is the upper left cell. The unit is one
// cell edge; a cell's centre has the cell's own coordinates.
#pragma once

#include <compare>

namespace pathrace {

struct Cell {
  int x = 0;
  int y = 0;

  friend auto operator<=>(const Cell&, const Cell&) = default;
};

struct Point {
  double x = 0;
  double y = 0;

  friend bool operator==(const Point&, const Point&) = default;
};

constexpr Point centre(Cell cell) {
  return {static_cast<double>(cell.x), static_cast<double>(cell.y)};
}

}  // namespace pathrace
