#include "results/canvas_map.hpp"

#include <cmath>

#include "results/rectangles.hpp"

namespace pathrace::results {
namespace {

void paint_grid_lines(Canvas& canvas, int left, int top, int scale, const OccupancyGrid& grid) {
  if (std::max(grid.width(), grid.height()) > finest_grid) return;
  for (int x = 1; x < grid.width(); ++x) {
    canvas.fill_rectangle(left + x * scale, top, 1, grid.height() * scale, palette.grid);
  }
  for (int y = 1; y < grid.height(); ++y) {
    canvas.fill_rectangle(left, top + y * scale, grid.width() * scale, 1, palette.grid);
  }
}

void paint_sharp(Canvas& canvas, int left, int top, int scale, const OccupancyGrid& grid) {
  canvas.fill_rectangle(left, top, grid.width() * scale, grid.height() * scale, palette.ground);
  paint_grid_lines(canvas, left, top, scale, grid);
  for (const Rectangle& r : blocked_rectangles(grid)) {
    canvas.fill_rectangle(left + r.x * scale, top + r.y * scale, r.width * scale, r.height * scale,
                          palette.obstacle);
  }
}

/// Cells that a pixel sees along one axis: part of the first, all between, part of the last.
struct Span {
  double begin;
  double end;
  int first() const { return static_cast<int>(begin); }
  int last(int cells) const { return std::min(cells, static_cast<int>(std::ceil(end))); }
  double share_of(int cell) const { return std::min(end, cell + 1.0) - std::max(begin, cell + 0.0); }
};

Span span_of(int pixel, double scale, int cells) {
  return {pixel / scale, std::min((pixel + 1) / scale, static_cast<double>(cells))};
}

// 0..255
int blocked_share(const OccupancyGrid& grid, const Span& across, const Span& down) {
  double blocked = 0;
  for (int y = down.first(); y < down.last(grid.height()); ++y) {
    for (int x = across.first(); x < across.last(grid.width()); ++x) {
      if (!grid.is_free({x, y})) blocked += across.share_of(x) * down.share_of(y);
    }
  }
  const double area = (across.end - across.begin) * (down.end - down.begin);
  return area > 0 ? static_cast<int>(std::lround(std::min(1.0, blocked / area) * 255)) : 0;
}

void paint_small(Canvas& canvas, int left, int top, double scale, const OccupancyGrid& grid) {
  const int width = std::min(static_cast<int>(std::ceil(grid.width() * scale)), canvas.width() - left);
  const int height = std::min(static_cast<int>(std::ceil(grid.height() * scale)), canvas.height() - top);
  canvas.fill_rectangle(left, top, width, height, palette.ground);
  for (int y = 0; y < height; ++y) {
    const Span down = span_of(y, scale, grid.height());
    for (int x = 0; x < width; ++x) {
      const int share = blocked_share(grid, span_of(x, scale, grid.width()), down);
      canvas.blend(left + x, top + y, palette.obstacle, share);
    }
  }
}

}  // namespace

void paint_ground(Canvas& canvas, int left, int top, double scale, const OccupancyGrid& grid) {
  if (scale >= 1) {
    paint_sharp(canvas, left, top, static_cast<int>(scale), grid);
  } else {
    paint_small(canvas, left, top, scale, grid);
  }
}

}  // namespace pathrace::results
