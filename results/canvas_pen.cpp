#include "results/canvas_pen.hpp"

#include <cmath>

#include "core/utf8.hpp"
#include "results/canvas_map.hpp"
#include "results/canvas_overlay.hpp"
#include "results/font.hpp"
#include "results/polyline.hpp"

namespace pathrace::results {
namespace {

/// How the font's unit and brush become pixels.
struct Brush {
  double unit;
  double width;
};

// A capital is 6 units and a brush high. Units are multiples of half a pixel, so that upright strokes look
// alike; that makes letters a little larger than their nominal size.
Brush brush_of(const TextStyle& style) {
  const double unit = std::max(1.0, std::round(style.size * 0.25) / 2);
  return {unit, unit * (style.weight == Weight::bold ? 1.2 : 0.85)};
}

double width_of(const Brush& brush, std::string_view text) {
  return text.empty() ? 0 : lettering(text).width * brush.unit - brush.unit + brush.width;
}

// The longest beginning that leaves room for an ellipsis.
std::string fitted(const Brush& brush, const std::string& text, double room) {
  if (width_of(brush, text) <= room) return text;
  const double before_ellipsis = room - width_of(brush, "\u2026");
  std::string_view rest = text;
  for (double width = 0; !rest.empty();) {
    const std::size_t size = std::max<std::size_t>(1, letter_size(rest));
    width += (lettering(rest.substr(0, size)).width + 1) * brush.unit;
    if (width > before_ellipsis) break;
    rest.remove_prefix(size);
  }
  return text.substr(0, text.size() - rest.size()) + "\u2026";
}

void draw_path(Canvas& canvas, const std::vector<Point>& points, double left, double top, double scale) {
  constexpr double far = 1e6;  // an answer that was refused may lead anywhere
  std::vector<Point> corners = corners_of(points);
  for (Point& corner : corners) {
    corner = {std::clamp(left + (corner.x + 0.5) * scale, -far, far),
              std::clamp(top + (corner.y + 0.5) * scale, -far, far)};
  }
  canvas.stroke(segments_of(corners), halo_width(scale) * scale, palette.paper);
  canvas.stroke(segments_of(corners), path_width(scale) * scale, palette.path);
}

void draw_frame(Canvas& canvas, int left, int top, int width, int height) {
  constexpr int half = static_cast<int>(frame_width) / 2;
  constexpr int thick = 2 * half;
  canvas.fill_rectangle(left - half, top - half, width + thick, thick, palette.obstacle);
  canvas.fill_rectangle(left - half, top + height - half, width + thick, thick, palette.obstacle);
  canvas.fill_rectangle(left - half, top - half, thick, height + thick, palette.obstacle);
  canvas.fill_rectangle(left + width - half, top - half, thick, height + thick, palette.obstacle);
}

}  // namespace

void CanvasPen::text(double x, double baseline, const TextStyle& style, const std::string& text,
                     double room) {
  const Brush brush = brush_of(style);
  Lettering letters = lettering(fitted(brush, text, room));
  const double left = x + brush.width / 2;
  const double top = baseline - brush.width / 2 - 6 * brush.unit;
  for (Segment& stroke : letters.strokes) {
    stroke.from = {left + stroke.from.x * brush.unit, top + stroke.from.y * brush.unit};
    stroke.to = {left + stroke.to.x * brush.unit, top + stroke.to.y * brush.unit};
  }
  canvas_.stroke(letters.strokes, brush.width, style.colour);
}

double CanvasPen::text_width(const TextStyle& style, const std::string& text) const {
  return width_of(brush_of(style), text);
}

void CanvasPen::map(double left, double top, double scale, const Scenario& scenario, const Answer& answer,
                    const Overlay& overlay) {
  const int x = static_cast<int>(left);
  const int y = static_cast<int>(top);
  const OccupancyGrid& grid = scenario.grid();
  const MapPlace place{x, y, scale};
  paint_ground(canvas_, x, y, scale, grid);
  paint_field(canvas_, place, overlay, grid);
  draw_frame(canvas_, x, y, static_cast<int>(std::ceil(grid.width() * scale)),
             static_cast<int>(std::ceil(grid.height() * scale)));
  paint_shapes(canvas_, place, overlay);
  if (answer) draw_path(canvas_, answer->points, x, y, scale);
  const double radius = mark_radius(scale) * scale;
  goal_mark(x + (scenario.goal.x + 0.5) * scale, y + (scenario.goal.y + 0.5) * scale, radius);
  start_mark(x + (scenario.start.x + 0.5) * scale, y + (scenario.start.y + 0.5) * scale, radius);
}

void CanvasPen::rectangle(double left, double top, double width, double height, Colour colour) {
  canvas_.fill_rectangle(static_cast<int>(left), static_cast<int>(top), static_cast<int>(std::ceil(width)),
                         static_cast<int>(std::ceil(height)), colour);
}

void CanvasPen::disc(Point centre, double radius, Colour colour) {
  canvas_.fill_disc(centre, radius, colour);
}

void CanvasPen::ring(Point centre, double radius, double width, Colour colour) {
  canvas_.draw_ring(centre, radius, width, colour);
}

void CanvasPen::line(const std::vector<Point>& points, double width, Colour colour) {
  if (points.size() > 1) canvas_.stroke(segments_of(points), width, colour);
}

void CanvasPen::start_mark(double x, double y, double radius) {
  const double edge = radius * mark::start_edge;
  canvas_.fill_disc({x, y}, radius * mark::start_disc + edge / 2, palette.paper);
  canvas_.fill_disc({x, y}, radius * mark::start_disc - edge / 2, palette.start);
}

void CanvasPen::goal_mark(double x, double y, double radius) {
  canvas_.fill_disc({x, y}, radius * (1 + mark::goal_halo / 2), palette.paper);
  canvas_.draw_ring({x, y}, radius, radius * mark::goal_ring, palette.goal);
  canvas_.fill_disc({x, y}, radius * mark::goal_heart, palette.goal);
}

void CanvasPen::path_mark(double x, double y, double length) {
  canvas_.stroke({{{x, y}, {x + length, y}}}, 3, palette.path);
}

}  // namespace pathrace::results
