// A scenario and an answer as a picture: title, caption, map with path, start and goal, legend.
#pragma once

#include <string>

#include "results/pen.hpp"

namespace pathrace::results {

/// Where things are, in pixels.
struct PictureLayout {
  double scale =
      1;  ///< pixels per cell: a whole number where a cell has one or more, so that edges stay sharp
  double map_width = 0;
  double map_height = 0;
  double margin = 16;
  double head = 56;  ///< room above the map for title and caption
  double foot = 36;  ///< room below it for the legend
  double width = 0;
  double height = 0;
  double left = 0;  ///< of the map
};

/// About 800 pixels, at most 1600 a side for the map, whatever its size.
PictureLayout layout_of(const OccupancyGrid& grid);

/// Points that are not finite are left out. Without an answer it shows the question.
void draw_picture(Pen& pen, const PictureLayout& layout, const Scenario& scenario, const Answer& answer,
                  const Overlay& overlay, const std::string& title);

}  // namespace pathrace::results
