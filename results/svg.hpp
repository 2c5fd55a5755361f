// A scenario and an answer as a picture: obstacles, path, start, goal, title and length.
#pragma once

#include <ostream>

#include "core/scenario.hpp"
#include "results/picture.hpp"

namespace pathrace::results {

/// A complete SVG 1.1 document of about 800 pixels, at most 1600 a side for the map, whatever its size.
/// Without an answer it shows the question; the overlay is what the planner thought, field, circles and line.
/// Points that are not finite are left out.
void write_svg(std::ostream& out, const Scenario& scenario, const Shown& shown);

}  // namespace pathrace::results
