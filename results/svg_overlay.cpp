// The field is one path per shade, made of runs of cells along the rows.
#include "results/svg_overlay.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <string>
#include <vector>

#include "results/overlay_style.hpp"

namespace pathrace::results {
namespace {

std::vector<std::string> runs_by_shade(const std::vector<int>& shades, int width, int height) {
  std::vector<std::string> runs(most_shade + 1);
  for (int y = 0; y < height; ++y) {
    const auto row = static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
    for (int x = 0; x < width;) {
      const int shade = shades[row + static_cast<std::size_t>(x)];
      int end = x + 1;
      while (end < width && shades[row + static_cast<std::size_t>(end)] == shade) ++end;
      runs[static_cast<std::size_t>(shade)] += fmt::format("M{} {}h{}v1h-{}z", x, y, end - x, end - x);
      x = end;
    }
  }
  return runs;
}

}  // namespace

void write_svg_field(std::ostream& out, const Overlay& overlay, const OccupancyGrid& grid) {
  if (overlay.field.empty()) return;
  const auto runs = runs_by_shade(shades_of(overlay.field), grid.width(), grid.height());
  for (std::size_t shade = 1; shade < runs.size(); ++shade) {
    if (runs[shade].empty()) continue;
    fmt::print(out,
               "<path class=\"field\" transform=\"translate(-0.5 -0.5)\" shape-rendering=\"crispEdges\" "
               "fill=\"{}\" fill-opacity=\"{:.3g}\" d=\"{}\"/>\n",
               css(shade_colour), strongest_shade * static_cast<double>(shade) / most_shade, runs[shade]);
  }
}

void write_svg_shapes(std::ostream& out, const Overlay& overlay, double scale,
                      const Palette<std::string>& paints) {
  const double width = overlay_line / scale;
  for (const OverlayCircle& circle : overlay.circles) {
    fmt::print(out,
               "<circle cx=\"{:.6g}\" cy=\"{:.6g}\" r=\"{:.6g}\" fill=\"none\" stroke=\"{}\" "
               "stroke-width=\"{:.4g}\"/>\n",
               circle.centre.x, circle.centre.y, circle.radius, paints.faint, width);
  }
  if (overlay.polyline.size() < 2) return;
  std::string points;
  for (const Point point : overlay.polyline) points += fmt::format("{:.6g},{:.6g} ", point.x, point.y);
  points.pop_back();
  fmt::print(out,
             "<polyline fill=\"none\" stroke=\"{}\" stroke-width=\"{:.4g}\" stroke-dasharray=\"{:.4g}\" "
             "points=\"{}\"/>\n",
             paints.start, width, overlay_dash * width, points);
}

}  // namespace pathrace::results
