// A scenario and an answer as a picture: title, caption, map with path, start and goal, legend.
#pragma once

#include <optional>
#include <string>

#include "core/record.hpp"
#include "results/pen.hpp"

namespace pathrace::results {

/// What a picture shows.
struct Shown {
  std::string title;
  Answer answer = {};                   ///< none: the question
  Track track = Track::lattice;         ///< whose optimum the caption states
  std::optional<Verdict> verdict = {};  ///< of the trial; unless solved, its path is no answer
  Overlay overlay = {};                 ///< what the planner thought

  bool solved() const { return !verdict || *verdict == Verdict::solved; }
};

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

/// Points that are not finite are left out. A path that is no answer is dashed on maps and grey in worlds,
/// and the caption says so.
void draw_picture(Pen& pen, const PictureLayout& layout, const Scenario& scenario, const Shown& shown);

}  // namespace pathrace::results
