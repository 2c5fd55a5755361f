// The gallery: many scenarios at a glance, one tile each.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "core/planner.hpp"
#include "core/scenario.hpp"
#include "results/pen.hpp"

namespace pathrace::results {

struct Tile {
  std::string title;    ///< the family's name
  std::string caption;  ///< the family in one line
  Scenario scenario;
  Answer answer;  ///< drawn when there is one
};

/// "20 × 20 · optimum 33.31"
std::string facts_of(const Scenario& scenario);

/// A contact sheet, 1200 pixels wide, as high as the tiles need.
struct Sheet {
  double width = 1200;
  double height = 0;
};
Sheet sheet_of(const std::vector<Tile>& tiles);
void draw_gallery(Pen& pen, const Sheet& sheet, const std::vector<Tile>& tiles);

/// The contact sheet as a complete file. write_gallery_png throws EnvironmentError when libpng fails.
void write_gallery_svg(std::ostream& out, const std::vector<Tile>& tiles);
void write_gallery_png(std::ostream& out, const std::vector<Tile>& tiles);

}  // namespace pathrace::results
