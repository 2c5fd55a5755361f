#include "algorithms/aco/tan/obstacles.hpp"

#include <algorithm>
#include <numbers>

#include "core/checkpoint.hpp"

namespace pathrace::algorithms {
namespace {

// Those of the first and the last cell of each row: their convex hull is that of all.
std::vector<Point> corners(const Obstacle& cells) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Cell cell = cells[i];
    const bool first = i == 0 || cells[i - 1].y != cell.y;
    const bool last = i + 1 == cells.size() || cells[i + 1].y != cell.y;
    if (!first && !last) continue;
    for (const double dy : {-0.5, 0.5}) {
      for (const double dx : {-0.5, 0.5}) points.push_back({cell.x + dx, cell.y + dy});
    }
  }
  return points;
}

// Both halves hold a cell: the bounding box is tight and its longer side has at least two cells.
std::pair<Obstacle, Obstacle> halves(const Obstacle& cells) {
  Cell low = cells.front();
  Cell high = cells.front();
  for (const Cell cell : cells) {
    low = {std::min(low.x, cell.x), std::min(low.y, cell.y)};
    high = {std::max(high.x, cell.x), std::max(high.y, cell.y)};
  }
  const bool across_x = high.x - low.x >= high.y - low.y;
  std::pair<Obstacle, Obstacle> parts;
  for (const Cell cell : cells) {
    const bool first = across_x ? 2 * cell.x < low.x + high.x : 2 * cell.y < low.y + high.y;
    (first ? parts.first : parts.second).push_back(cell);
  }
  return parts;
}

void cover_into(std::vector<Circle>& circles, const Obstacle& cells, const CoverSettings& settings, int depth,
                const Stream& order) {
  checkpoint();
  const Circle circle = smallest_enclosing_circle(corners(cells), order);
  const double area = std::numbers::pi * circle.radius * circle.radius;
  const bool tight = area <= settings.area_ratio * static_cast<double>(cells.size());
  if (tight || cells.size() == 1 || depth == settings.max_depth) {
    circles.push_back(circle);
    return;
  }
  const auto [first, second] = halves(cells);
  cover_into(circles, first, settings, depth + 1, order.fork(0));
  cover_into(circles, second, settings, depth + 1, order.fork(1));
}

}  // namespace

std::vector<Circle> cover(const Obstacle& obstacle, const CoverSettings& settings, const Stream& order) {
  std::vector<Circle> circles;
  cover_into(circles, obstacle, settings, 0, order);
  return circles;
}

std::vector<Circle> cover(const OccupancyGrid& grid, const CoverSettings& settings, const Stream& order) {
  std::vector<Circle> circles;
  const std::vector<Obstacle> obstacles = obstacles_of(grid, settings.neighbours);
  for (std::size_t i = 0; i < obstacles.size(); ++i) {
    cover_into(circles, obstacles[i], settings, 0, order.fork(i));
  }
  return circles;
}

}  // namespace pathrace::algorithms
