#include "results/picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/gap.hpp"
#include "results/polyline.hpp"
#include "results/world_picture.hpp"

namespace pathrace::results {
namespace {

double scale_of(int longest) {
  constexpr double usual = 800;
  constexpr double largest = 1600;
  if (longest > largest) return largest / longest;
  return std::clamp(std::round(usual / longest), 1.0, 48.0);
}

std::string caption_of(const Scenario& scenario, const Answer& answer) {
  std::string caption = answer ? fmt::format("length {:.2f}", polyline_length(answer->points)) : "no path";
  const auto optimum = reference_length(scenario, answer ? answer->track : Track::lattice);
  if (optimum) caption += fmt::format("  \u00b7  optimum {:.2f}", *optimum);
  const OccupancyGrid& grid = scenario.grid();
  return caption + fmt::format("  \u00b7  {} \u00d7 {} cells  \u00b7  rule {}", grid.width(), grid.height(),
                               name(scenario.terrain.rule));
}

void draw_legend(Pen& pen, const PictureLayout& layout, const Scenario& scenario) {
  const double y = layout.head + layout.map_height + 21;
  const TextStyle style{12, Weight::normal, palette.faint};
  const std::string start = fmt::format("start {},{}", scenario.start.x, scenario.start.y);
  const std::string goal = fmt::format("goal {},{}", scenario.goal.x, scenario.goal.y);
  const double left = layout.margin + 7;
  const double middle = left + 150;
  pen.start_mark(left, y, 7);
  pen.text(left + 13, y + 4, style, start, 130);
  pen.goal_mark(middle, y, 7);
  pen.text(middle + 13, y + 4, style, goal, 130);
}

}  // namespace

PictureLayout layout_of(const OccupancyGrid& grid) {
  constexpr double narrowest = 400;  // title and legend want room
  PictureLayout layout;
  layout.scale = scale_of(std::max(grid.width(), grid.height()));
  layout.map_width = grid.width() * layout.scale;
  layout.map_height = grid.height() * layout.scale;
  layout.width = std::ceil(std::max(layout.map_width, narrowest) + 2 * layout.margin);
  layout.height = std::ceil(layout.map_height + layout.head + layout.foot);
  layout.left = std::floor((layout.width - layout.map_width) / 2);
  return layout;
}

void draw_picture(Pen& pen, const PictureLayout& layout, const Scenario& scenario, const Answer& answer,
                  const Overlay& overlay, const std::string& title) {
  if (scenario.world) return draw_world_picture(pen, layout, *scenario.world, answer, overlay, title);
  const double room = layout.width - 2 * layout.margin;
  pen.text(layout.margin, 25, {16, Weight::bold, palette.ink}, title, room);
  pen.text(layout.margin, 44, {12, Weight::normal, palette.faint}, caption_of(scenario, answer), room);
  pen.map(layout.left, layout.head, layout.scale, scenario, answer, overlay);
  draw_legend(pen, layout, scenario);
}

}  // namespace pathrace::results
