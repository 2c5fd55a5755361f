#include "tests/support/crooked_path.hpp"

#include <set>

#include "tests/support/oracle.hpp"

namespace pathrace::testing {

std::vector<Cell> crooked_path(const OccupancyGrid& grid, MoveRule rule, Cell start, Cell goal,
                               Stream stream) {
  std::vector<Cell> path{start};
  std::set<Cell> visited{start};
  while (!path.empty() && path.back() != goal) {
    std::vector<Cell> fresh;
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const Cell next{path.back().x + dx, path.back().y + dy};
        if (oracle_step(grid, rule, path.back(), next) && visited.count(next) == 0) fresh.push_back(next);
      }
    }
    if (fresh.empty()) {
      path.pop_back();
      continue;
    }
    path.push_back(fresh[stream.below(fresh.size())]);
    visited.insert(path.back());
  }
  return path;
}

}  // namespace pathrace::testing
