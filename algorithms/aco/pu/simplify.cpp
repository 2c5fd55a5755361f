#include "algorithms/aco/pu/simplify.hpp"

#include <array>
#include <cstdlib>

namespace pathrace::algorithms {
namespace {

constexpr int none = -1;

// Of two steps in a row: the one step that leads to the same cell, and the direction that leads there in two
// steps straight on, if there is such a one. That is no diagonal: legal wherever its cell is free, so where
// the first step is legal the second is, too.
struct Corner {
  int joined = none;
  int straight = none;
};

constexpr int direction_of(Cell displacement) {
  for (int d = 0; d < direction_count; ++d) {
    if (directions[static_cast<std::size_t>(d)] == displacement) return d;
  }
  return none;
}

constexpr Corner corner_of(int first, int second) {
  const Cell a = directions[static_cast<std::size_t>(first)];
  const Cell b = directions[static_cast<std::size_t>(second)];
  const Cell sum{a.x + b.x, a.y + b.y};
  const bool halves = sum.x % 2 == 0 && sum.y % 2 == 0 && first != second;
  return {direction_of(sum), halves ? direction_of({sum.x / 2, sum.y / 2}) : none};
}

using CornerTable = std::array<std::array<Corner, direction_count>, direction_count>;

constexpr CornerTable corner_table = [] {
  CornerTable table{};
  for (int first = 0; first < direction_count; ++first) {
    for (int second = 0; second < direction_count; ++second) {
      table[static_cast<std::size_t>(first)][static_cast<std::size_t>(second)] = corner_of(first, second);
    }
  }
  return table;
}();

const Corner& corner(std::uint8_t first, std::uint8_t second) {
  return corner_table[first][second];
}

bool legal(const MoveTable& moves, std::size_t from, int direction) {
  return direction != none && (moves[from] >> direction & 1) != 0;
}

bool turns(Cell a, Cell b, Cell c) {
  const std::int64_t cross = std::int64_t{b.x - a.x} * (c.y - b.y) - std::int64_t{b.y - a.y} * (c.x - b.x);
  const std::int64_t dot = std::int64_t{b.x - a.x} * (c.x - b.x) + std::int64_t{b.y - a.y} * (c.y - b.y);
  return cross != 0 || dot < 0;
}

}  // namespace

bool CornerCutter::cut(std::size_t start, std::vector<std::uint8_t>& directions) {
  if (!has_corner(start, directions)) return false;
  path_.clear();
  push({static_cast<std::uint32_t>(start), 0});
  std::size_t cell = start;
  for (const std::uint8_t direction : directions) {
    cell = moves_.step(cell, direction);
    append({static_cast<std::uint32_t>(cell), direction});
  }
  directions.clear();
  for (const Arrival& arrival : path_) {
    if (place_[arrival.cell] > 1) directions.push_back(arrival.direction);
    place_[arrival.cell] = 0;
  }
  return true;
}

bool CornerCutter::has_corner(std::size_t start, const std::vector<std::uint8_t>& directions) const {
  std::size_t before = start;
  for (std::size_t k = 1; k < directions.size(); ++k) {
    const Corner& here = corner(directions[k - 1], directions[k]);
    if (legal(moves_, before, here.joined) || legal(moves_, before, here.straight)) return true;
    before = moves_.step(before, directions[k - 1]);
  }
  return false;
}

// The next cell, a step from path_.back(); it may shorten what is there.
void CornerCutter::append(Arrival next) {
  while (place_[next.cell] == 0) {
    if (path_.size() < 2) return push(next);
    const std::size_t before = path_[path_.size() - 2].cell;
    const Corner& here = corner(path_.back().direction, next.direction);
    if (legal(moves_, before, here.joined)) {
      drop();
      next.direction = static_cast<std::uint8_t>(here.joined);
    } else if (legal(moves_, before, here.straight)) {
      drop();
      next.direction = static_cast<std::uint8_t>(here.straight);
      append({static_cast<std::uint32_t>(moves_.step(before, here.straight)), next.direction});
    } else {
      return push(next);
    }
  }
  while (path_.size() > place_[next.cell]) drop();
}

void CornerCutter::push(Arrival next) {
  path_.push_back(next);
  place_[next.cell] = static_cast<std::uint32_t>(path_.size());
}

void CornerCutter::drop() {
  place_[path_.back().cell] = 0;
  path_.pop_back();
}

// Walks through the cells under the segment. After i columns and j rows the next column's border lies at
// (2i + 1) / (2 dx) of the way, the next row's at (2j + 1) / (2 dy); equal means through the corner itself.
bool line_of_sight(const OccupancyGrid& grid, Cell from, Cell to) {
  const std::int64_t dx = std::abs(to.x - from.x);
  const std::int64_t dy = std::abs(to.y - from.y);
  const int step_x = to.x > from.x ? 1 : -1;
  const int step_y = to.y > from.y ? 1 : -1;
  Cell cell = from;
  std::int64_t i = 0;
  std::int64_t j = 0;
  while (i < dx || j < dy) {
    const std::int64_t order = (2 * i + 1) * dy - (2 * j + 1) * dx;
    if (order == 0 && !grid.is_free({cell.x + step_x, cell.y}) && !grid.is_free({cell.x, cell.y + step_y})) {
      return false;
    }
    if (order <= 0) {
      cell.x += step_x;
      ++i;
    }
    if (order >= 0) {
      cell.y += step_y;
      ++j;
    }
    if (!grid.is_free(cell)) return false;
  }
  return true;
}

std::vector<Cell> straightened(const OccupancyGrid& grid, const std::vector<Cell>& path) {
  std::vector<Cell> points;
  for (const Cell cell : path) {
    while (points.size() >= 2 && turns(points[points.size() - 2], points.back(), cell) &&
           line_of_sight(grid, points[points.size() - 2], cell)) {
      points.pop_back();
    }
    points.push_back(cell);
  }
  return points;
}

}  // namespace pathrace::algorithms
