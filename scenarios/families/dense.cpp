// Dense maps: a given percentage of the cells is blocked, uniformly at random.
//
// Corner to corner, as the papers on metaheuristic planners do. The number of blocked cells is exact; maps
// without a way are rejected, so the family is uniform over the solvable maps of its density. The limit of
// 40 % is the percolation threshold of `strict` moves (a free cluster needs 59.3 % of the cells).
#include <fmt/format.h>

#include <cmath>

#include "core/error.hpp"
#include "scenarios/family.hpp"

namespace pathrace::scenarios {
namespace {

Sketch draw(int n, int percent, Stream stream) {
  Sketch sketch{OccupancyGrid(n, n), {0, 0}, {n - 1, n - 1}};
  std::vector<Cell> cells;  // all but start and goal, so that any of them may be blocked
  cells.reserve(static_cast<std::size_t>(n) * static_cast<std::size_t>(n) - 2);
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x < n; ++x) {
      const Cell cell{x, y};
      if (cell != sketch.start && cell != sketch.goal) cells.push_back(cell);
    }
  }
  const std::size_t blocked =
      (static_cast<std::size_t>(percent) * static_cast<std::size_t>(n * n) + 50) / 100;
  for (std::size_t i = 0; i < blocked && i < cells.size(); ++i) {
    std::swap(cells[i], cells[i + stream.below(cells.size() - i)]);
    sketch.grid.block(cells[i]);
  }
  return sketch;
}

Scenario make(const std::string& id, const std::vector<std::string_view>& parts) {
  static constexpr std::string_view form = "dense/<n>-<percent>/<seed>";
  require_parts(id, form, parts, 2);
  const std::size_t dash = parts[0].find('-');
  if (dash == std::string_view::npos)
    throw InputError(fmt::format("scenario '{}': expected the form {}", id, form));
  const int n = id_number(id, "n", parts[0].substr(0, dash), least_side, most_side);
  const int percent = id_number(id, "percent", parts[0].substr(dash + 1), 0, 40);
  id_number(id, "seed", parts[1], 0, most_seed);
  return certified(id, [=](Stream stream) { return draw(n, percent, stream); });
}

}  // namespace

Family dense_family() {
  return {"dense", "dense/<n>-<percent>/<seed>", "n x n cells, exactly <percent> % of them blocked at random",
          thirty_seeds(
              {"dense/10-10", "dense/10-20", "dense/10-30", "dense/20-10", "dense/20-20", "dense/20-30"}),
          make};
}

}  // namespace pathrace::scenarios
