#include "tests/support/any_angle_oracle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace pathrace::testing {
namespace {

// Doubled coordinates: cell (x, y) is the open square (2x - 1, 2x + 1) x (2y - 1, 2y + 1).
struct Node {
  int x;
  int y;
};

int cross(Node p, Node q, int x, int y) {
  return (q.x - p.x) * (y - p.y) - (q.y - p.y) * (x - p.x);
}

bool in_box(Node p, Node q, int x, int y) {
  return std::min(p.x, q.x) <= x && x <= std::max(p.x, q.x) && std::min(p.y, q.y) <= y &&
         y <= std::max(p.y, q.y);
}

bool enters_square(Node p, Node q, int x, int y) {
  if (std::max(p.x, q.x) <= 2 * x - 1 || std::min(p.x, q.x) >= 2 * x + 1) return false;
  if (std::max(p.y, q.y) <= 2 * y - 1 || std::min(p.y, q.y) >= 2 * y + 1) return false;
  int left = 0;
  int right = 0;
  for (const int cx : {2 * x - 1, 2 * x + 1}) {
    for (const int cy : {2 * y - 1, 2 * y + 1}) {
      left += cross(p, q, cx, cy) > 0 ? 1 : 0;
      right += cross(p, q, cx, cy) < 0 ? 1 : 0;
    }
  }
  return left > 0 && right > 0;
}

// The upper left of the four cells around the corner is (x, y).
bool is_pinched(const OccupancyGrid& grid, int x, int y) {
  const bool falling = grid.is_free({x, y}) && grid.is_free({x + 1, y + 1});
  const bool rising = grid.is_free({x + 1, y}) && grid.is_free({x, y + 1});
  const bool no_falling = !grid.is_free({x, y}) && !grid.is_free({x + 1, y + 1});
  const bool no_rising = !grid.is_free({x + 1, y}) && !grid.is_free({x, y + 1});
  return (falling && no_rising) || (rising && no_falling);
}

// Does the segment run along a piece of the lower or right edge of (x, y), with that cell and the one beyond
// the edge both blocked?
bool runs_inside_wall(const OccupancyGrid& grid, Node p, Node q, int x, int y) {
  if (grid.is_free({x, y})) return false;
  if (p.y == q.y && p.y == 2 * y + 1 && !grid.is_free({x, y + 1})) {
    return std::min(p.x, q.x) < 2 * x + 1 && std::max(p.x, q.x) > 2 * x - 1;
  }
  if (p.x == q.x && p.x == 2 * x + 1 && !grid.is_free({x + 1, y})) {
    return std::min(p.y, q.y) < 2 * y + 1 && std::max(p.y, q.y) > 2 * y - 1;
  }
  return false;
}

bool is_legal(const OccupancyGrid& grid, Node p, Node q) {
  for (int y = -1; y <= grid.height(); ++y) {
    for (int x = -1; x <= grid.width(); ++x) {
      if (!grid.is_free({x, y}) && enters_square(p, q, x, y)) return false;
      if (runs_inside_wall(grid, p, q, x, y)) return false;
      const bool on_corner = cross(p, q, 2 * x + 1, 2 * y + 1) == 0 && in_box(p, q, 2 * x + 1, 2 * y + 1);
      if (on_corner && is_pinched(grid, x, y)) return false;
    }
  }
  return true;
}

std::vector<Node> nodes_of(const OccupancyGrid& grid, Cell start, Cell goal) {
  std::vector<Node> nodes{{2 * start.x, 2 * start.y}, {2 * goal.x, 2 * goal.y}};
  for (int y = -1; y <= 2 * grid.height() - 1; y += 2) {
    for (int x = -1; x <= 2 * grid.width() - 1; x += 2) nodes.push_back({x, y});
  }
  return nodes;
}

}  // namespace

std::optional<double> oracle_any_angle(const OccupancyGrid& grid, Cell start, Cell goal) {
  constexpr double far = std::numeric_limits<double>::infinity();
  const std::vector<Node> nodes = nodes_of(grid, start, goal);
  std::vector<double> length(nodes.size(), far);
  std::vector<bool> done(nodes.size());
  length[0] = 0;
  for (;;) {
    std::size_t here = nodes.size();
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (!done[i] && length[i] < far && (here == nodes.size() || length[i] < length[here])) here = i;
    }
    if (here == nodes.size()) return std::nullopt;
    if (here == 1) return length[1];
    done[here] = true;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const double step = std::hypot(nodes[i].x - nodes[here].x, nodes[i].y - nodes[here].y) / 2;
      if (length[here] + step < length[i] && is_legal(grid, nodes[here], nodes[i])) {
        length[i] = length[here] + step;
      }
    }
  }
}

}  // namespace pathrace::testing
