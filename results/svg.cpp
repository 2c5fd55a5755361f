// The map is drawn in cell units inside a scaled and shifted group, so that its numbers are the cells' own;
// text is drawn in pixels around it. Widths that must stay visible on large maps are given in pixels and
// divided by the scale.
#include "results/svg.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "results/rectangles.hpp"
#include "results/utf8.hpp"
#include "results/xml.hpp"

namespace pathrace::results {
namespace {

namespace colour {
constexpr const char* paper = "#ffffff";
constexpr const char* ground = "#fbfaf6";
constexpr const char* grid = "#e4e0d6";
constexpr const char* obstacle = "#3b4452";
constexpr const char* path = "#e8590c";  // orange and teal differ for every kind of colour vision
constexpr const char* start = "#0b7285";
constexpr const char* goal = "#c2255c";
constexpr const char* ink = "#212529";
constexpr const char* faint = "#6b7280";
}  // namespace colour

constexpr const char* font = "font-family=\"Helvetica, Arial, 'DejaVu Sans', sans-serif\"";
constexpr int finest_grid = 64;  // grid lines on maps up to so many cells a side

/// Where things are, in pixels.
struct Layout {
  double scale;  ///< pixels per cell
  double map_width;
  double map_height;
  double margin = 16;
  double head = 56;  ///< room above the map for title and caption
  double foot = 36;  ///< room below it for the legend
  double width;
  double height;
  double left;  ///< of the map
};

// Whole pixels per cell where a cell has one or more, so that edges stay sharp.
double scale_of(int longest) {
  constexpr double usual = 800;
  constexpr double largest = 1600;
  if (longest > largest) return largest / longest;
  return std::clamp(std::round(usual / longest), 1.0, 48.0);
}

Layout layout_of(const OccupancyGrid& grid) {
  constexpr double narrowest = 400;  // title and legend want room
  Layout layout{};
  layout.scale = scale_of(std::max(grid.width(), grid.height()));
  layout.map_width = grid.width() * layout.scale;
  layout.map_height = grid.height() * layout.scale;
  layout.width = std::ceil(std::max(layout.map_width, narrowest) + 2 * layout.margin);
  layout.height = std::ceil(layout.map_height + layout.head + layout.foot);
  layout.left = std::floor((layout.width - layout.map_width) / 2);
  return layout;
}

// --- text ------------------------------------------------------------------------------------------

// Cut to what fits: about 0.56 em per letter in a proportional font.
std::string fitted(const std::string& text, double width, double font_size) {
  const auto most = static_cast<std::size_t>(width / (0.56 * font_size));
  if (letter_count(text) <= most) return text;
  std::string_view rest = text;
  for (std::size_t i = 0; i + 1 < most; ++i) rest.remove_prefix(std::max<std::size_t>(1, letter_size(rest)));
  return text.substr(0, text.size() - rest.size()) + "\u2026";
}

double polyline_length(const std::vector<Point>& points) {
  double length = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    length += std::hypot(points[i].x - points[i - 1].x, points[i].y - points[i - 1].y);
  }
  return length;
}

std::string caption_of(const Scenario& scenario, const Answer& answer) {
  std::string caption = answer ? fmt::format("length {:.2f}", polyline_length(answer->points)) : "no path";
  if (scenario.optimum.length)
    caption += fmt::format("  \u00b7  optimum {:.2f}", scenario.optimum.length->value());
  const OccupancyGrid& grid = scenario.grid();
  return caption + fmt::format("  \u00b7  {} \u00d7 {} cells  \u00b7  rule {}", grid.width(), grid.height(),
                               name(scenario.terrain.rule));
}

void write_line(std::ostream& out, double x, double y, double size, const char* fill, const char* weight,
                const std::string& text, double room) {
  fmt::print(out, "<text x=\"{}\" y=\"{}\" {} font-size=\"{}\" font-weight=\"{}\" fill=\"{}\">{}</text>\n", x,
             y, font, size, weight, fill, xml_text(fitted(text, room, size)));
}

// --- map -------------------------------------------------------------------------------------------

// In the map's group, cell (0, 0) covers -0.5..0.5; integers stay integers when the shape is moved.
void write_obstacles(std::ostream& out, const OccupancyGrid& grid) {
  fmt::print(out, "<path transform=\"translate(-0.5 -0.5)\" fill=\"{}\" shape-rendering=\"crispEdges\" d=\"",
             colour::obstacle);
  for (const Rectangle& r : blocked_rectangles(grid)) {
    fmt::print(out, "M{} {}h{}v{}h-{}z", r.x, r.y, r.width, r.height, r.width);
  }
  out << "\"/>\n";
}

void write_grid_lines(std::ostream& out, const OccupancyGrid& grid, double scale) {
  if (std::max(grid.width(), grid.height()) > finest_grid) return;
  fmt::print(
      out,
      "<path transform=\"translate(-0.5 -0.5)\" fill=\"none\" stroke=\"{}\" stroke-width=\"{:.4g}\" d=\"",
      colour::grid, 1 / scale);
  for (int x = 1; x < grid.width(); ++x) fmt::print(out, "M{} 0v{}", x, grid.height());
  for (int y = 1; y < grid.height(); ++y) fmt::print(out, "M0 {}h{}", y, grid.width());
  out << "\"/>\n";
}

void write_rectangle(std::ostream& out, const OccupancyGrid& grid, const std::string& style) {
  fmt::print(out, "<rect x=\"-0.5\" y=\"-0.5\" width=\"{}\" height=\"{}\" {}/>\n", grid.width(),
             grid.height(), style);
}

bool straight_on(Point a, Point b, Point c) {
  const double cross = (b.x - a.x) * (c.y - b.y) - (b.y - a.y) * (c.x - b.x);
  const double dot = (b.x - a.x) * (c.x - b.x) + (b.y - a.y) * (c.y - b.y);
  return cross == 0 && dot > 0;
}

// The corners alone: a straight run needs its two ends.
std::vector<Point> corners_of(const std::vector<Point>& points) {
  std::vector<Point> corners;
  for (const Point point : points) {
    if (!std::isfinite(point.x) || !std::isfinite(point.y)) continue;
    const std::size_t n = corners.size();
    if (n >= 2 && straight_on(corners[n - 2], corners[n - 1], point)) corners.pop_back();
    corners.push_back(point);
  }
  return corners;
}

void write_polyline(std::ostream& out, const std::string& points, const char* stroke, double width) {
  fmt::print(out,
             "<polyline fill=\"none\" stroke=\"{}\" stroke-width=\"{:.4g}\" stroke-linejoin=\"round\" "
             "stroke-linecap=\"round\" points=\"{}\"/>\n",
             stroke, width, points);
}

void write_path(std::ostream& out, const std::vector<Point>& corners, double scale) {
  if (corners.empty()) return;
  std::string points;
  for (const Point corner : corners) {
    points += fmt::format("{}{:.6g},{:.6g}", points.empty() ? "" : " ", corner.x, corner.y);
  }
  const double width = std::max(0.17, 2.5 / scale);
  write_polyline(out, points, colour::paper, width + std::max(0.08, 2 / scale));  // a halo
  write_polyline(out, points, colour::path, width);
}

void write_ring(std::ostream& out, double x, double y, double radius, const char* fill, const char* stroke,
                double width) {
  fmt::print(out,
             "<circle cx=\"{}\" cy=\"{}\" r=\"{:.4g}\" fill=\"{}\" stroke=\"{}\" "
             "stroke-width=\"{:.4g}\"/>\n",
             x, y, radius, fill, stroke, width);
}

// The goal's ring leaves room for the start's disc: both show when start and goal are one cell.
void write_start(std::ostream& out, double x, double y, double radius) {
  write_ring(out, x, y, radius * 0.7, colour::start, colour::paper, radius * 0.22);
}

void write_goal(std::ostream& out, double x, double y, double radius) {
  write_ring(out, x, y, radius, colour::paper, colour::paper, radius * 0.62);
  write_ring(out, x, y, radius, colour::paper, colour::goal, radius * 0.3);
  write_ring(out, x, y, radius * 0.38, colour::goal, "none", 0);
}

void write_map(std::ostream& out, const Scenario& scenario, const Answer& answer, const Layout& layout) {
  const OccupancyGrid& grid = scenario.grid();
  const double scale = layout.scale;
  fmt::print(out, "<g transform=\"translate({} {}) scale({:.6g}) translate(0.5 0.5)\">\n", layout.left,
             layout.head, scale);
  write_rectangle(out, grid, fmt::format("fill=\"{}\"", colour::ground));
  write_grid_lines(out, grid, scale);
  write_obstacles(out, grid);
  write_rectangle(
      out, grid,
      fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"{:.4g}\"", colour::obstacle, 2 / scale));
  if (answer) write_path(out, corners_of(answer->points), scale);
  const double radius = std::max(0.34, 7 / scale);
  write_goal(out, scenario.goal.x, scenario.goal.y, radius);
  write_start(out, scenario.start.x, scenario.start.y, radius);
  out << "</g>\n";
}

void write_legend(std::ostream& out, const Scenario& scenario, const Layout& layout) {
  const double y = layout.head + layout.map_height + 21;
  const std::string start = fmt::format("start {},{}", scenario.start.x, scenario.start.y);
  const std::string goal = fmt::format("goal {},{}", scenario.goal.x, scenario.goal.y);
  const double left = layout.margin + 7;
  const double middle = left + 150;
  write_start(out, left, y, 7);
  write_line(out, left + 13, y + 4, 12, colour::faint, "normal", start, 130);
  write_goal(out, middle, y, 7);
  write_line(out, middle + 13, y + 4, 12, colour::faint, "normal", goal, 130);
}

}  // namespace

void write_svg(std::ostream& out, const Scenario& scenario, const Answer& answer, const std::string& title) {
  const Layout layout = layout_of(scenario.grid());
  const double room = layout.width - 2 * layout.margin;
  fmt::print(
      out,
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\">\n",
      layout.width, layout.height);
  fmt::print(out, "<title>{}</title>\n<rect width=\"100%\" height=\"100%\" fill=\"{}\"/>\n", xml_text(title),
             colour::paper);
  write_line(out, layout.margin, 25, 16, colour::ink, "bold", title, room);
  write_line(out, layout.margin, 44, 12, colour::faint, "normal", caption_of(scenario, answer), room);
  write_map(out, scenario, answer, layout);
  write_legend(out, scenario, layout);
  out << "</svg>\n";
}

}  // namespace pathrace::results
