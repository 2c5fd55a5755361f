// Numbers on the map are the cells' own; widths that must stay visible on large maps are given in pixels
// and divided by the scale.
#include "results/svg_map.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include "results/polyline.hpp"
#include "results/rectangles.hpp"
#include "results/svg_overlay.hpp"

namespace pathrace::results {
namespace {

// Integers stay integers when the shape is moved by half a cell.
void write_obstacles(std::ostream& out, const OccupancyGrid& grid, const std::string& paint) {
  fmt::print(out, "<path transform=\"translate(-0.5 -0.5)\" fill=\"{}\" shape-rendering=\"crispEdges\" d=\"",
             paint);
  for (const Rectangle& r : blocked_rectangles(grid)) {
    fmt::print(out, "M{} {}h{}v{}h-{}z", r.x, r.y, r.width, r.height, r.width);
  }
  out << "\"/>\n";
}

void write_grid_lines(std::ostream& out, const OccupancyGrid& grid, double scale, const std::string& paint) {
  if (std::max(grid.width(), grid.height()) > finest_grid) return;
  fmt::print(
      out,
      "<path transform=\"translate(-0.5 -0.5)\" fill=\"none\" stroke=\"{}\" stroke-width=\"{:.4g}\" d=\"",
      paint, 1 / scale);
  for (int x = 1; x < grid.width(); ++x) fmt::print(out, "M{} 0v{}", x, grid.height());
  for (int y = 1; y < grid.height(); ++y) fmt::print(out, "M0 {}h{}", y, grid.width());
  out << "\"/>\n";
}

void write_rectangle(std::ostream& out, const OccupancyGrid& grid, const std::string& style) {
  fmt::print(out, "<rect x=\"-0.5\" y=\"-0.5\" width=\"{}\" height=\"{}\" {}/>\n", grid.width(),
             grid.height(), style);
}

void write_polyline(std::ostream& out, const std::string& points, const std::string& stroke, double width) {
  fmt::print(out,
             "<polyline fill=\"none\" stroke=\"{}\" stroke-width=\"{:.4g}\" stroke-linejoin=\"round\" "
             "stroke-linecap=\"round\" points=\"{}\"/>\n",
             stroke, width, points);
}

void write_path(std::ostream& out, const std::vector<Point>& corners, double scale,
                const Palette<std::string>& paints) {
  if (corners.empty()) return;
  std::string points;
  for (const Point corner : corners) {
    points += fmt::format("{}{:.6g},{:.6g}", points.empty() ? "" : " ", corner.x, corner.y);
  }
  write_polyline(out, points, paints.paper, halo_width(scale));
  write_polyline(out, points, paints.path, path_width(scale));
}

void write_circle(std::ostream& out, double x, double y, double radius, const std::string& fill,
                  const std::string& stroke, double width) {
  fmt::print(out,
             "<circle cx=\"{}\" cy=\"{}\" r=\"{:.4g}\" fill=\"{}\" stroke=\"{}\" "
             "stroke-width=\"{:.4g}\"/>\n",
             x, y, radius, fill, stroke, width);
}

}  // namespace

void write_svg_start(std::ostream& out, double x, double y, double radius,
                     const Palette<std::string>& paints) {
  write_circle(out, x, y, radius * mark::start_disc, paints.start, paints.paper, radius * mark::start_edge);
}

void write_svg_goal(std::ostream& out, double x, double y, double radius,
                    const Palette<std::string>& paints) {
  write_circle(out, x, y, radius, paints.paper, paints.paper, radius * mark::goal_halo);
  write_circle(out, x, y, radius, paints.paper, paints.goal, radius * mark::goal_ring);
  write_circle(out, x, y, radius * mark::goal_heart, paints.goal, "none", 0);
}

void write_svg_map(std::ostream& out, const Scenario& scenario, const Answer& answer, const Overlay& overlay,
                   double scale, const Palette<std::string>& paints) {
  const OccupancyGrid& grid = scenario.grid();
  write_rectangle(out, grid, fmt::format("fill=\"{}\"", paints.ground));
  write_svg_field(out, overlay, grid);
  write_grid_lines(out, grid, scale, paints.grid);
  write_obstacles(out, grid, paints.obstacle);
  write_rectangle(out, grid,
                  fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"{:.4g}\"", paints.obstacle,
                              frame_width / scale));
  write_svg_shapes(out, overlay, scale, paints);
  if (answer) write_path(out, corners_of(answer->points), scale, paints);
  const double radius = mark_radius(scale);
  write_svg_goal(out, scenario.goal.x, scenario.goal.y, radius, paints);
  write_svg_start(out, scenario.start.x, scenario.start.y, radius, paints);
}

}  // namespace pathrace::results
