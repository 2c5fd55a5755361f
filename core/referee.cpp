#include "core/referee.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace pathrace {
namespace {

std::string text(Point point) {
  return fmt::format("{},{}", point.x, point.y);
}

// --- lattice ---------------------------------------------------------------------------------------

std::optional<Cell> cell_at(Point point) {
  if (std::floor(point.x) != point.x || std::floor(point.y) != point.y) return std::nullopt;
  if (std::fabs(point.x) > OccupancyGrid::max_side || std::fabs(point.y) > OccupancyGrid::max_side) {
    return std::nullopt;
  }
  return Cell{static_cast<int>(point.x), static_cast<int>(point.y)};
}

bool diagonal_allowed(const OccupancyGrid& grid, MoveRule rule, Cell from, Cell to) {
  const bool one_side = grid.is_free({to.x, from.y});
  const bool other_side = grid.is_free({from.x, to.y});
  switch (rule) {
    case MoveRule::four: return false;
    case MoveRule::strict: return one_side && other_side;
    case MoveRule::squeeze: return one_side || other_side;
    case MoveRule::free: return true;
  }
  return false;
}

std::string lattice_fault(const Path& path, const Terrain& terrain) {
  const OccupancyGrid& grid = *terrain.grid;
  std::optional<Cell> previous;
  for (const Point point : path.points) {
    const std::optional<Cell> cell = cell_at(point);
    if (!cell) return fmt::format("{} is not a cell", text(point));
    if (!grid.contains(*cell)) return fmt::format("{} is outside the map", text(point));
    if (!grid.is_free(*cell)) return fmt::format("{} is blocked", text(point));
    if (previous) {
      const int dx = std::abs(cell->x - previous->x);
      const int dy = std::abs(cell->y - previous->y);
      if (dx > 1 || dy > 1 || dx + dy == 0) {
        return fmt::format("{} to {} is not a step", text(centre(*previous)), text(point));
      }
      if (dx + dy == 2 && !diagonal_allowed(grid, terrain.rule, *previous, *cell)) {
        return fmt::format("{} to {} cuts a corner under the rule '{}'", text(centre(*previous)), text(point),
                           name(terrain.rule));
      }
    }
    previous = cell;
  }
  return "";
}

// --- any angle -------------------------------------------------------------------------------------

double cross(Point origin, Point a, Point b) {
  return (a.x - origin.x) * (b.y - origin.y) - (a.y - origin.y) * (b.x - origin.x);
}

// Does the segment enter the open unit square around the cell? Two convex sets are apart when one of the
// axes x, y and the segment's normal separates them.
bool enters(Point p, Point q, Cell cell) {
  const double left = cell.x - 0.5;
  const double right = cell.x + 0.5;
  const double top = cell.y - 0.5;
  const double bottom = cell.y + 0.5;
  if (std::max(p.x, q.x) <= left || std::min(p.x, q.x) >= right) return false;
  if (std::max(p.y, q.y) <= top || std::min(p.y, q.y) >= bottom) return false;
  if (p == q) return true;
  const double corners[] = {cross(p, q, {left, top}), cross(p, q, {right, top}), cross(p, q, {left, bottom}),
                            cross(p, q, {right, bottom})};
  const auto [least, most] = std::minmax_element(std::begin(corners), std::end(corners));
  return *least < 0 && *most > 0;
}

bool on_segment(Point p, Point q, Point v) {
  return cross(p, q, v) == 0 && v.x >= std::min(p.x, q.x) && v.x <= std::max(p.x, q.x) &&
         v.y >= std::min(p.y, q.y) && v.y <= std::max(p.y, q.y);
}

// The corner shared by two blocked cells that touch only there, with the other two cells free, is closed:
// a path that keeps to one side of it never needs to touch it.
bool closed_corner(const OccupancyGrid& grid, Cell upper_left) {
  const bool a = grid.is_free(upper_left);
  const bool b = grid.is_free({upper_left.x + 1, upper_left.y});
  const bool c = grid.is_free({upper_left.x, upper_left.y + 1});
  const bool d = grid.is_free({upper_left.x + 1, upper_left.y + 1});
  return a == d && b == c && a != b;
}

// The line between two blocked cells that share an edge is in neither open square, and yet inside a wall.
// Does the segment run along the lower edge of this blocked cell, and is the cell below blocked too?
bool slides_below(const OccupancyGrid& grid, Point p, Point q, Cell cell) {
  return p.y == cell.y + 0.5 && q.y == p.y && std::min(p.x, q.x) < cell.x + 0.5 &&
         std::max(p.x, q.x) > cell.x - 0.5 && !grid.is_free({cell.x, cell.y + 1});
}
bool slides_right(const OccupancyGrid& grid, Point p, Point q, Cell cell) {
  return p.x == cell.x + 0.5 && q.x == p.x && std::min(p.y, q.y) < cell.y + 0.5 &&
         std::max(p.y, q.y) > cell.y - 0.5 && !grid.is_free({cell.x + 1, cell.y});
}

// The first and the last column that the segment comes near on its way from row y - 2 to y + 2.
std::pair<int, int> columns_near(Point p, Point q, int y) {
  double low = std::min(p.x, q.x);
  double high = std::max(p.x, q.x);
  if (p.y != q.y) {
    const auto x_at = [&](double row) {
      return p.x + std::clamp((row - p.y) / (q.y - p.y), 0.0, 1.0) * (q.x - p.x);
    };
    std::tie(low, high) = std::minmax({x_at(y - 2), x_at(y + 2)});
  }
  return {static_cast<int>(std::floor(low)) - 2, static_cast<int>(std::ceil(high)) + 2};
}

std::string segment_fault(const OccupancyGrid& grid, Point p, Point q) {
  const int top = static_cast<int>(std::floor(std::min(p.y, q.y)));
  const int bottom = static_cast<int>(std::ceil(std::max(p.y, q.y)));
  for (int y = top - 1; y <= bottom + 1; ++y) {
    const auto [first, last] = columns_near(p, q, y);
    for (int x = first; x <= last; ++x) {
      const Cell cell{x, y};
      if (grid.contains(cell) && !grid.is_free(cell) && enters(p, q, cell)) {
        return fmt::format("{} to {} enters the blocked cell {},{}", text(p), text(q), x, y);
      }
      if (closed_corner(grid, cell) && on_segment(p, q, {x + 0.5, y + 0.5})) {
        return fmt::format("{} to {} passes between blocked cells at {},{}", text(p), text(q), x + 0.5,
                           y + 0.5);
      }
      if (!grid.is_free(cell) && (slides_below(grid, p, q, cell) || slides_right(grid, p, q, cell))) {
        return fmt::format("{} to {} passes between blocked cells along the edge of {},{}", text(p), text(q),
                           x, y);
      }
    }
  }
  return "";
}

std::string any_angle_fault(const Path& path, const OccupancyGrid& grid) {
  for (const Point point : path.points) {
    const bool inside =
        point.x >= -0.5 && point.y >= -0.5 && point.x <= grid.width() - 0.5 && point.y <= grid.height() - 0.5;
    if (!inside) return fmt::format("{} is outside the map", text(point));  // NaN lands here too
  }
  for (std::size_t i = 0; i < path.points.size(); ++i) {
    const Point previous = path.points[i == 0 ? 0 : i - 1];
    std::string fault = segment_fault(grid, previous, path.points[i]);
    if (!fault.empty()) return fault;
  }
  return "";
}

}  // namespace

Referee::Referee(const Terrain& terrain) : terrain_(terrain), clearance_(*terrain.grid) {}

std::string Referee::fault_of(const Path& path, Cell start, Cell goal) const {
  if (path.points.empty()) return "the path is empty";
  if (path.points.front() != centre(start)) {
    return fmt::format("begins at {}, not at the start {}", text(path.points.front()), text(centre(start)));
  }
  if (path.points.back() != centre(goal)) {
    return fmt::format("ends at {}, not at the goal {}", text(path.points.back()), text(centre(goal)));
  }
  return path.track == Track::lattice ? lattice_fault(path, terrain_) : any_angle_fault(path, *terrain_.grid);
}

Judgement Referee::judge(const Path& path, Cell start, Cell goal) const {
  Judgement judgement;
  judgement.fault = fault_of(path, start, goal);
  if (judgement.legal()) judgement.metrics = measure(path, clearance_);
  return judgement;
}

}  // namespace pathrace
