// A scenario and an answer as a PNG picture: what write_svg draws, in pixels.
#pragma once

#include <ostream>

#include "core/scenario.hpp"
#include "results/picture.hpp"

namespace pathrace::results {

/// A complete PNG file of about 800 pixels, at most 1600 a side for the map, whatever its size; equal
/// arguments give equal bytes. Without an answer it shows the question. Points that are not finite are left
/// out. Throws EnvironmentError when libpng fails.
void write_png(std::ostream& out, const Scenario& scenario, const Shown& shown);

}  // namespace pathrace::results
