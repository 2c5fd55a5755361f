#include "algorithms/aco/pu/simplify.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <optional>

namespace pathrace::algorithms {
namespace {

// The direction of the step between two padded indices; -1 when they are not neighbours.
int direction_of(const MoveTable& moves, std::uint32_t from, std::uint32_t to) {
  const std::ptrdiff_t difference = static_cast<std::ptrdiff_t>(to) - static_cast<std::ptrdiff_t>(from);
  for (int d = 0; d < direction_count; ++d) {
    if (moves.offset(d) == difference) return d;
  }
  return -1;
}

bool legal(const MoveTable& moves, std::uint32_t from, std::uint32_t to) {
  const int d = direction_of(moves, from, to);
  return d >= 0 && (moves[from] >> d & 1) != 0;
}

// The cell inside a corner of two diagonal steps, when it can be passed straight.
std::optional<std::uint32_t> inside(const MoveTable& moves, std::uint32_t a, std::uint32_t b,
                                    std::uint32_t c) {
  const int first = direction_of(moves, a, b);
  const int second = direction_of(moves, b, c);
  if (!is_diagonal(first) || !is_diagonal(second)) return std::nullopt;
  const int turn = (second - first + direction_count) & 7;
  if (turn != 2 && turn != 6) return std::nullopt;
  const int middle = (turn == 2 ? first + 1 : first - 1) & 7;
  const auto cell = static_cast<std::uint32_t>(moves.step(a, middle));
  if (legal(moves, a, cell) && legal(moves, cell, c)) return cell;
  return std::nullopt;
}

// A path being rebuilt from its start; the cell that arrives next may shorten what is there.
class Rebuilt {
 public:
  explicit Rebuilt(const MoveTable& moves) : moves_(moves), place_(moves.size(), 0) {}

  void append(std::uint32_t cell) {
    if (place_[cell] != 0) return cut_back_to(place_[cell]);
    while (path_.size() >= 2) {
      const std::uint32_t before = path_[path_.size() - 2];
      if (legal(moves_, before, cell)) {
        drop();
        continue;
      }
      const std::optional<std::uint32_t> middle = inside(moves_, before, path_.back(), cell);
      if (!middle) break;
      drop();
      append(*middle);
      return append(cell);
    }
    path_.push_back(cell);
    place_[cell] = path_.size();
  }

  std::vector<std::uint32_t> take() { return std::move(path_); }

 private:
  void drop() {
    place_[path_.back()] = 0;
    path_.pop_back();
  }
  void cut_back_to(std::size_t size) {
    while (path_.size() > size) drop();
  }

  const MoveTable& moves_;
  std::vector<std::size_t> place_;  // position on the path from 1
  std::vector<std::uint32_t> path_;
};

bool turns(Cell a, Cell b, Cell c) {
  const std::int64_t cross = std::int64_t{b.x - a.x} * (c.y - b.y) - std::int64_t{b.y - a.y} * (c.x - b.x);
  const std::int64_t dot = std::int64_t{b.x - a.x} * (c.x - b.x) + std::int64_t{b.y - a.y} * (c.y - b.y);
  return cross != 0 || dot < 0;
}

}  // namespace

std::vector<std::uint32_t> without_corners(const MoveTable& moves, const std::vector<std::uint32_t>& path) {
  Rebuilt rebuilt(moves);
  for (const std::uint32_t cell : path) rebuilt.append(cell);
  return rebuilt.take();
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
