#include "results/canvas_overlay.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "results/overlay_style.hpp"

namespace pathrace::results {
namespace {

Point placed(const MapPlace& place, Point point) {
  constexpr double far = 1e5;  // an answer that was refused may lead anywhere
  return {std::clamp(place.left + (point.x + 0.5) * place.scale, -far, far),
          std::clamp(place.top + (point.y + 0.5) * place.scale, -far, far)};
}

void shade_cell(Canvas& canvas, const MapPlace& place, Cell cell, int shade) {
  const int side = static_cast<int>(place.scale);
  const int coverage = static_cast<int>(255 * strongest_shade * shade / most_shade);
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      canvas.blend(place.left + cell.x * side + x, place.top + cell.y * side + y, shade_colour, coverage);
    }
  }
}

}  // namespace

void paint_field(Canvas& canvas, const MapPlace& place, const Overlay& overlay, const OccupancyGrid& grid) {
  if (overlay.field.empty() || place.scale < 1) return;
  const std::vector<int> shades = shades_of(overlay.field);
  std::size_t i = 0;
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x, ++i) {
      if (shades[i] > 0 && grid.is_free({x, y})) shade_cell(canvas, place, {x, y}, shades[i]);
    }
  }
}

void paint_shapes(Canvas& canvas, const MapPlace& place, const Overlay& overlay) {
  for (const OverlayCircle& circle : overlay.circles) {
    canvas.draw_ring(placed(place, circle.centre), circle.radius * place.scale, overlay_line, palette.faint);
  }
  std::vector<Point> line;
  for (const Point point : overlay.polyline) line.push_back(placed(place, point));
  if (line.size() > 1)
    canvas.stroke(dashes_of(line, overlay_dash * overlay_line), overlay_line, palette.start);
}

}  // namespace pathrace::results
