// The contact sheet: a heading with the legend, then rows of tiles.
//
// A tile is the family's name, the map in a square slot, the id, size and optimum, and what the family is,
// in three lines. A cell has a whole number of pixels, so that edges are sharp.
#include "results/gallery.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace pathrace::results {
namespace {

constexpr std::size_t columns = 5;
constexpr double margin = 32;
constexpr double gap = 24;
constexpr double head = 92;
constexpr double slot_top = 16;  // below the tile's top
constexpr double line = 18;      // from one line of text to the next
constexpr int caption_lines = 3;

const TextStyle heading{24, Weight::bold, palette.ink};
const TextStyle strong{16, Weight::bold, palette.ink};
const TextStyle plain{12, Weight::normal, palette.ink};
const TextStyle quiet{12, Weight::normal, palette.faint};

double slot_of(const Sheet& sheet) {
  return std::floor((sheet.width - 2 * margin - (columns - 1) * gap) / columns);
}

double tile_height(const Sheet& sheet) {
  return slot_top + slot_of(sheet) + (2 + caption_lines) * line + 12 + gap;
}

// Words into lines of at most `room` pixels; the last line takes the rest, and the pen cuts it.
std::vector<std::string> wrapped(const Pen& pen, const TextStyle& style, const std::string& text, double room,
                                 std::size_t most) {
  std::vector<std::string> lines{""};
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    const std::string longer = lines.back().empty() ? word : lines.back() + ' ' + word;
    const bool fits = pen.text_width(style, longer) <= room || lines.back().empty() || lines.size() == most;
    if (fits) {
      lines.back() = longer;
    } else {
      lines.push_back(word);
    }
  }
  return lines;
}

double scale_in(double slot, const OccupancyGrid& grid) {
  const double scale = slot / std::max(grid.width(), grid.height());
  return scale >= 1 ? std::floor(scale) : scale;
}

void draw_tile(Pen& pen, double left, double top, double slot, const Tile& tile) {
  pen.text(left, top, strong, tile.title, slot);
  const double map_top = top + slot_top;
  const OccupancyGrid& grid = tile.scenario.grid();
  const double scale = scale_in(slot, grid);
  const double lower = std::floor((slot - grid.height() * scale) / 2);
  const double inner = std::floor((slot - grid.width() * scale) / 2);
  pen.map(left + inner, map_top + lower, scale, tile.scenario, tile.answer, {});
  double baseline = map_top + slot + line + 6;
  pen.text(left, baseline, plain, tile.scenario.id, slot);
  pen.text(left, baseline += line, plain, facts_of(tile.scenario), slot);
  baseline += 2;
  for (const std::string& words : wrapped(pen, quiet, tile.caption, slot, caption_lines)) {
    pen.text(left, baseline += line, quiet, words, slot);
  }
}

// From right to left, so that it ends at the margin.
void draw_legend(Pen& pen, double right, double baseline) {
  constexpr double apart = 28;
  const double middle = baseline - 5;
  const auto word = [&](const std::string& text) {
    right -= pen.text_width(plain, text);
    pen.text(right, baseline, plain, text, 400);
    right -= 8;
  };
  word("a shortest path");
  pen.path_mark(right - 26, middle, 24);
  right -= 28 + apart;
  word("goal");
  pen.goal_mark(right - 8, middle, 7);
  right -= 16 + apart;
  word("start");
  pen.start_mark(right - 6, middle, 8);
}

}  // namespace

std::string facts_of(const Scenario& scenario) {
  std::string facts = fmt::format("{} \u00d7 {}", scenario.grid().width(), scenario.grid().height());
  if (scenario.optimum.length)
    facts += fmt::format(" \u00b7 optimum {:.2f}", scenario.optimum.length->value());
  if (scenario.optimum.proven && !scenario.optimum.length) facts += " \u00b7 no way";
  return facts;
}

Sheet sheet_of(const std::vector<Tile>& tiles) {
  Sheet sheet;
  const std::size_t rows = (tiles.size() + columns - 1) / columns;
  sheet.height = head + static_cast<double>(rows) * tile_height(sheet);
  return sheet;
}

void draw_gallery(Pen& pen, const Sheet& sheet, const std::vector<Tile>& tiles) {
  pen.text(margin, 48, heading, "pathrace scenarios", sheet.width / 2);
  draw_legend(pen, sheet.width - margin, 48);
  const double slot = slot_of(sheet);
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    const double left = margin + static_cast<double>(i % columns) * (slot + gap);
    const std::size_t row = i / columns;
    const double top = head + static_cast<double>(row) * tile_height(sheet);
    draw_tile(pen, left, top, slot, tiles[i]);
  }
}

}  // namespace pathrace::results
