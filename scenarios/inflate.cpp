// A blocked square k columns and m rows away is d(k, m) = (g(k)^2 + g(m)^2)^(1/2) / 2 from a cell's centre,
// where g(0) = 0 and g(k) = 2k - 1. So the nearest blocked cell in a column, k rows away, blocks the cells of
// this row up to reach[k] columns to either side. A row is the union of these intervals.
#include "scenarios/inflate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/error.hpp"

namespace pathrace::scenarios {
namespace {

double squared_gap(int cells) {
  const double doubled = cells == 0 ? 0 : 2.0 * cells - 1;
  return doubled * doubled;
}

// reach[k]: the most columns that a blocked square k rows away may lie aside and still be too near; shorter
// than `rows` where no square that far is.
std::vector<int> reaches(double radius, int rows, int columns) {
  const double limit = 4 * radius * radius * (1 - 1e-9);
  std::vector<int> reach;
  int aside = columns;
  for (int k = 0; k < rows && squared_gap(k) < limit; ++k) {
    while (squared_gap(aside) + squared_gap(k) >= limit) --aside;
    reach.push_back(aside);
  }
  return reach;
}

// For each cell of the map the rows to the nearest blocked cell of its column, at most `most`.
std::vector<int> rows_to_blocked(const OccupancyGrid& grid, int most) {
  const auto width = static_cast<std::size_t>(grid.width());
  const auto height = static_cast<std::size_t>(grid.height());
  std::vector<int> rows(width * height);
  for (std::size_t y = 0; y < height; ++y) {
    const std::size_t first = grid.index({0, static_cast<int>(y)});
    for (std::size_t x = 0; x < width; ++x) {
      const int above = y == 0 ? most : std::min(most, rows[(y - 1) * width + x] + 1);
      rows[y * width + x] = grid.blocked_at(first + x) ? 0 : above;
    }
  }
  for (std::size_t y = height - 1; y-- > 0;) {
    for (std::size_t x = 0; x < width; ++x) {
      rows[y * width + x] = std::min(rows[y * width + x], rows[(y + 1) * width + x] + 1);
    }
  }
  return rows;
}

}  // namespace

OccupancyGrid inflated(const OccupancyGrid& grid, double radius) {
  if (!(radius >= 0)) throw InputError(fmt::format("a radius of {}; expected at least 0", radius));
  OccupancyGrid grown = grid;
  const std::vector<int> reach = reaches(radius, grid.height(), grid.width());
  if (reach.empty()) return grown;
  const int none = static_cast<int>(reach.size());
  const std::vector<int> rows = rows_to_blocked(grid, none);
  const int width = grid.width();
  std::vector<int> begins(static_cast<std::size_t>(width) + 1);  // intervals that begin here, less those past
  for (int y = 0; y < grid.height(); ++y) {
    std::fill(begins.begin(), begins.end(), 0);
    const int* const row = rows.data() + static_cast<std::ptrdiff_t>(y) * width;
    for (int x = 0; x < width; ++x) {
      if (row[x] == none) continue;
      const int aside = reach[static_cast<std::size_t>(row[x])];
      ++begins[static_cast<std::size_t>(std::max(0, x - aside))];
      --begins[static_cast<std::size_t>(std::min(width, x + aside + 1))];
    }
    int covering = 0;
    for (int x = 0; x < width; ++x) {
      covering += begins[static_cast<std::size_t>(x)];
      if (covering > 0) grown.block({x, y});
    }
  }
  return grown;
}

}  // namespace pathrace::scenarios
