#include "results/rectangles.hpp"

namespace pathrace::results {
namespace {

std::vector<Rectangle> runs_of_row(const OccupancyGrid& grid, int y) {
  std::vector<Rectangle> runs;
  for (int x = 0; x < grid.width();) {
    int end = x;
    while (end < grid.width() && !grid.is_free({end, y})) ++end;
    if (end > x) runs.push_back({x, y, end - x, 1});
    x = end + 1;
  }
  return runs;
}

// Both lists are sorted by x. A rectangle above grows into an equal run; the others are finished.
void grow(std::vector<Rectangle>& open, std::vector<Rectangle>& runs, std::vector<Rectangle>& finished) {
  auto above = open.begin();
  for (Rectangle& run : runs) {
    while (above != open.end() && above->x < run.x) finished.push_back(*above++);
    if (above == open.end() || above->x != run.x) continue;
    if (above->width == run.width) {
      run.y = above->y;
      run.height = above->height + 1;
    } else {
      finished.push_back(*above);
    }
    ++above;
  }
  finished.insert(finished.end(), above, open.end());
  open.swap(runs);
}

}  // namespace

std::vector<Rectangle> blocked_rectangles(const OccupancyGrid& grid) {
  std::vector<Rectangle> finished;
  std::vector<Rectangle> open;
  for (int y = 0; y < grid.height(); ++y) {
    std::vector<Rectangle> runs = runs_of_row(grid, y);
    grow(open, runs, finished);
  }
  finished.insert(finished.end(), open.begin(), open.end());
  return finished;
}

}  // namespace pathrace::results
