#include "bench/micro/textbook_astar.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <queue>

namespace pathrace::bench::micro {
namespace {

struct Open {
  double f;
  double g;
  Cell cell;

  bool operator<(const Open& other) const { return f != other.f ? f > other.f : g < other.g; }
};

double octile(Cell a, Cell b) {
  const double dx = std::abs(a.x - b.x);
  const double dy = std::abs(a.y - b.y);
  return std::max(dx, dy) + (std::numbers::sqrt2 - 1) * std::min(dx, dy);
}

bool step_allowed(const OccupancyGrid& grid, Cell from, int dx, int dy) {
  if (!grid.is_free({from.x + dx, from.y + dy})) return false;
  return grid.is_free({from.x + dx, from.y}) && grid.is_free({from.x, from.y + dy});
}

}  // namespace

TextbookAnswer textbook_astar(const OccupancyGrid& grid, Cell start, Cell goal) {
  std::vector<double> cost(grid.padded_size(), std::numeric_limits<double>::infinity());
  std::vector<Cell> parent(grid.padded_size());
  std::vector<bool> closed(grid.padded_size());
  std::priority_queue<Open> open;
  TextbookAnswer answer;
  cost[grid.index(start)] = 0;
  open.push({octile(start, goal), 0, start});
  while (!open.empty()) {
    const Cell cell = open.top().cell;
    open.pop();
    if (closed[grid.index(cell)]) continue;
    closed[grid.index(cell)] = true;
    if (cell == goal) break;
    ++answer.expanded;
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        if ((dx == 0 && dy == 0) || !step_allowed(grid, cell, dx, dy)) continue;
        const Cell next{cell.x + dx, cell.y + dy};
        const double next_cost = cost[grid.index(cell)] + (dx != 0 && dy != 0 ? std::numbers::sqrt2 : 1.0);
        if (next_cost >= cost[grid.index(next)]) continue;
        cost[grid.index(next)] = next_cost;
        parent[grid.index(next)] = cell;
        open.push({next_cost + octile(next, goal), next_cost, next});
      }
    }
  }
  if (!closed[grid.index(goal)]) return answer;
  answer.length = cost[grid.index(goal)];
  for (Cell cell = goal; cell != start; cell = parent[grid.index(cell)]) answer.cells.push_back(cell);
  answer.cells.push_back(start);
  std::reverse(answer.cells.begin(), answer.cells.end());
  return answer;
}

}  // namespace pathrace::bench::micro
