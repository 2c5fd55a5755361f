// Cards in a grid that fills the window; a card is a family, with its maps side by side. The maps' paints are
// names of the style sheet, which knows two sets of colours.
#include "results/gallery_html.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>

#include "results/gallery_style.hpp"
#include "results/svg_map.hpp"
#include "results/xml.hpp"

namespace pathrace::results {
namespace {

const Palette<std::string> names = {
    .paper = "var(--paper)",
    .ground = "var(--ground)",
    .grid = "var(--grid)",
    .obstacle = "var(--obstacle)",
    .path = "var(--path)",
    .start = "var(--start)",
    .goal = "var(--goal)",
    .ink = "var(--ink)",
    .faint = "var(--faint)",
};

using Tiles = std::vector<Tile>::const_iterator;

Tiles end_of_card(Tiles first, Tiles last) {
  return std::find_if(first, last, [&](const Tile& tile) { return tile.title != first->title; });
}

std::string counted(std::size_t count, const char* one, const char* many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

void write_map(std::ostream& out, const Tile& tile) {
  constexpr double usual = 220;  // pixels that a map is shown with, about
  const OccupancyGrid& grid = tile.scenario.grid();
  const double scale = usual / std::max(grid.width(), grid.height());
  const double edge = frame_width / 2 / scale;
  fmt::print(out,
             "<svg role=\"img\" aria-label=\"Map {0}, {1}\" viewBox=\"{2:.4g} {2:.4g} {3:.6g} {4:.6g}\">\n"
             "<title>{0}</title>\n",
             xml_text(tile.scenario.id), facts_of(tile.scenario), -0.5 - edge, grid.width() + 2 * edge,
             grid.height() + 2 * edge);
  write_svg_map(out, tile.scenario, tile.answer, {}, scale, names);
  out << "</svg>\n";
}

void write_figure(std::ostream& out, const Tile& tile) {
  out << "<figure>\n";
  write_map(out, tile);
  fmt::print(out, "<figcaption><code>{}</code><span>{}</span></figcaption>\n</figure>\n",
             xml_text(tile.scenario.id), facts_of(tile.scenario));
}

void write_card(std::ostream& out, Tiles first, Tiles last) {
  const std::string title = xml_text(first->title);
  fmt::print(out, "<section id=\"{0}\" aria-labelledby=\"{0}-name\">\n<h2 id=\"{0}-name\">{0}</h2>\n", title);
  fmt::print(out, "<p>{}</p>\n<div class=\"maps\">\n", xml_text(first->caption));
  for (; first != last; ++first) write_figure(out, *first);
  out << "</div>\n</section>\n";
}

// A mark of the legend, in a box of 24 x 24 pixels.
template <typename Draw>
void write_key(std::ostream& out, const char* text, const Draw& draw) {
  out << "<li><svg class=\"key\" aria-hidden=\"true\" viewBox=\"-12 -12 24 24\">\n";
  draw();
  fmt::print(out, "</svg>{}</li>\n", text);
}

void write_legend(std::ostream& out) {
  out << "<ul class=\"legend\" aria-label=\"Legend\">\n";
  write_key(out, "start", [&] { write_svg_start(out, 0, 0, 10, names); });
  write_key(out, "goal", [&] { write_svg_goal(out, 0, 0, 8, names); });
  write_key(out, "a shortest path", [&] {
    fmt::print(out, "<path stroke=\"{}\" stroke-width=\"4\" stroke-linecap=\"round\" d=\"M-9 0h18\"/>\n",
               names.path);
  });
  write_key(out, "obstacle", [&] {
    fmt::print(out, "<rect x=\"-8\" y=\"-8\" width=\"16\" height=\"16\" fill=\"{}\"/>\n", names.obstacle);
  });
  out << "</ul>\n";
}

void write_head(std::ostream& out, const std::vector<Tile>& tiles) {
  std::size_t families = 0;
  for (auto card = tiles.begin(); card != tiles.end(); card = end_of_card(card, tiles.end())) ++families;
  out << "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n"
         "<meta name=\"color-scheme\" content=\"light dark\"/>\n"
         "<title>pathrace scenarios</title>\n<style>\n"
      << gallery_style << "</style>\n</head>\n<body>\n<header>\n<h1>pathrace scenarios</h1>\n";
  fmt::print(out,
             "<p>{}, {}. An id names the same map on every machine; optima are proven by exact search.</p>\n",
             counted(families, "family", "families"), counted(tiles.size(), "map", "maps"));
  write_legend(out);
  out << "</header>\n<main>\n";
}

}  // namespace

void write_gallery_html(std::ostream& out, const std::vector<Tile>& tiles) {
  write_head(out, tiles);
  for (auto card = tiles.begin(); card != tiles.end();) {
    const auto next = end_of_card(card, tiles.end());
    write_card(out, card, next);
    card = next;
  }
  out << "</main>\n</body>\n</html>\n";
}

}  // namespace pathrace::results
