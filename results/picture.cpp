#include "results/picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/gap.hpp"
#include "results/outcome_count.hpp"
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

// What came out, with a separator behind it; nothing for a question.
std::string outcome_of(const Shown& shown, const std::vector<Point>& dashed) {
  if (shown.solved() && !shown.answer) return "";
  std::string text = shown.solved() ? fmt::format("length {:.2f}", polyline_length(shown.answer->points))
                                    : in_words(*shown.verdict);
  if (!shown.solved() && !dashed.empty()) {
    text += fmt::format("  \u00b7  dashed: no answer, length {:.2f}", polyline_length(dashed));
  }
  return text + "  \u00b7  ";
}

std::string caption_of(const Scenario& scenario, const Shown& shown, const std::vector<Point>& dashed) {
  std::string caption = outcome_of(shown, dashed);
  const auto optimum = reference_length(scenario, shown.track);
  if (optimum) caption += fmt::format("optimum {:.2f}  \u00b7  ", *optimum);
  const OccupancyGrid& grid = scenario.grid();
  return caption + fmt::format("{} \u00d7 {} cells  \u00b7  rule {}", grid.width(), grid.height(),
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

void draw_picture(Pen& pen, const PictureLayout& layout, const Scenario& scenario, const Shown& shown) {
  if (scenario.world) return draw_world_picture(pen, layout, *scenario.world, shown);
  Overlay overlay = shown.overlay;
  if (!shown.solved() && shown.answer) overlay.polyline = corners_of(shown.answer->points);
  const double room = layout.width - 2 * layout.margin;
  pen.text(layout.margin, 25, {16, Weight::bold, palette.ink}, shown.title, room);
  pen.text(layout.margin, 44, {12, Weight::normal, palette.faint},
           caption_of(scenario, shown, overlay.polyline), room);
  pen.map(layout.left, layout.head, layout.scale, scenario, shown.solved() ? shown.answer : std::nullopt,
          overlay);
  draw_legend(pen, layout, scenario);
}

}  // namespace pathrace::results
