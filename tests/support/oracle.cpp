#include "tests/support/oracle.hpp"

#include <cstdint>
#include <cstdlib>
#include <map>
#include <set>
#include <vector>

namespace pathrace::testing {
namespace {

std::vector<Cell> all_cells(const OccupancyGrid& grid) {
  std::vector<Cell> cells;
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x) cells.push_back({x, y});
  }
  return cells;
}

std::vector<Cell> steps_from(const OccupancyGrid& grid, MoveRule rule, Cell from) {
  std::vector<Cell> steps;
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      const Cell to{from.x + dx, from.y + dy};
      if (oracle_step(grid, rule, from, to)) steps.push_back(to);
    }
  }
  return steps;
}

}  // namespace

// t -> t|t| keeps order and sign, so s + d sqrt 2 has the sign of s|s| + 2 d|d|.
int sign_of(std::int64_t straight, std::int64_t diagonal) {
  __extension__ using Wide = __int128;
  const Wide s = straight;
  const Wide d = diagonal;
  const Wide sum = s * (s < 0 ? -s : s) + 2 * d * (d < 0 ? -d : d);
  return sum < 0 ? -1 : sum > 0 ? 1 : 0;
}

bool oracle_step(const OccupancyGrid& grid, MoveRule rule, Cell from, Cell to) {
  if (!grid.is_free(from) || !grid.is_free(to)) return false;
  const bool same_column = from.x == to.x;
  const bool same_row = from.y == to.y;
  if (same_column && same_row) return false;
  if (std::abs(from.x - to.x) > 1 || std::abs(from.y - to.y) > 1) return false;
  if (same_column || same_row) return true;
  if (rule == MoveRule::four) return false;
  if (rule == MoveRule::free) return true;
  const bool beside_from_is_blocked = !grid.is_free(Cell{to.x, from.y});
  const bool beside_to_is_blocked = !grid.is_free(Cell{from.x, to.y});
  if (rule == MoveRule::squeeze) return !(beside_from_is_blocked && beside_to_is_blocked);
  return !(beside_from_is_blocked || beside_to_is_blocked);
}

std::optional<LatticeLength> oracle_optimum(const OccupancyGrid& grid, MoveRule rule, Cell start, Cell goal) {
  std::map<Cell, LatticeLength> best;
  best[start] = {0, 0};
  for (bool changed = true; changed;) {
    changed = false;
    for (const Cell from : all_cells(grid)) {
      const auto reached = best.find(from);
      if (reached == best.end()) continue;
      const LatticeLength here = reached->second;
      for (const Cell to : steps_from(grid, rule, from)) {
        const bool straight = from.x == to.x || from.y == to.y;
        const LatticeLength there{here.straight + (straight ? 1 : 0), here.diagonal + (straight ? 0 : 1)};
        const auto known = best.find(to);
        if (known != best.end() &&
            sign_of(there.straight - known->second.straight, there.diagonal - known->second.diagonal) >= 0) {
          continue;
        }
        best[to] = there;
        changed = true;
      }
    }
  }
  const auto found = best.find(goal);
  if (found == best.end()) return std::nullopt;
  return found->second;
}

bool oracle_reachable(const OccupancyGrid& grid, MoveRule rule, Cell start, Cell goal) {
  std::set<Cell> seen{start};
  std::vector<Cell> frontier{start};
  while (!frontier.empty()) {
    const Cell cell = frontier.back();
    frontier.pop_back();
    for (const Cell next : steps_from(grid, rule, cell)) {
      if (seen.insert(next).second) frontier.push_back(next);
    }
  }
  return seen.count(goal) != 0;
}

}  // namespace pathrace::testing
