// Dense maps: a given percentage of the cells is blocked, uniformly at random.
//
// Corner to corner, as the papers on metaheuristic planners do. The number of blocked cells is exact; maps
// without a way are rejected, so the family is uniform over the solvable maps of its density. The limit of
// 40 % is the percolation threshold of `strict` moves (a free cluster needs 59.3 % of the cells).
#include <utility>

#include "scenarios/generated.hpp"

namespace pathrace::scenarios {
namespace {

struct DenseSettings : Placement {
  int percent = 20;
};

Sketch draw(const DenseSettings& settings, int n, Stream& stream) {
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
      (static_cast<std::size_t>(settings.percent) * static_cast<std::size_t>(n * n) + 50) / 100;
  for (std::size_t i = 0; i < blocked && i < cells.size(); ++i) {
    std::swap(cells[i], cells[i + stream.below(cells.size() - i)]);
    sketch.grid.block(cells[i]);
  }
  return sketch;
}

}  // namespace

Family dense_family() {
  const GeneratedCard card{"dense",
                           "an exact percentage of the cells blocked at random, corner to corner",
                           "percent",
                           Ends::own,
                           {"10-10", "10-20", "10-30", "20-10", "20-20", "20-30"}};
  return generated_family<DenseSettings>(
      card, {integer("percent", &DenseSettings::percent, 0, 40, "%", Source::ours, "blocked cells")}, draw);
}

}  // namespace pathrace::scenarios
