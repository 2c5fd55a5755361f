// The blocked cells of a grid as few rectangles.
//
// Runs of blocked cells along a row; equal runs in rows below one another become one rectangle. Not the
// least possible number, but walls and rooms come out as one each, in one pass.
#pragma once

#include <vector>

#include "core/grid.hpp"

namespace pathrace::results {

struct Rectangle {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;

  friend bool operator==(const Rectangle&, const Rectangle&) = default;
};

/// Disjoint, and together exactly the blocked cells.
std::vector<Rectangle> blocked_rectangles(const OccupancyGrid& grid);

}  // namespace pathrace::results
