// Text as strokes, for canvases.
#pragma once

#include <string_view>
#include <vector>

#include "results/raster.hpp"

namespace pathrace::results {

/// Lines to be drawn with a round brush. The unit is the distance between two dots of the font: a capital is
/// six high, y = 0 is its upper edge, y = 6 the baseline, tails reach 8; x = 0 is the first letter's left
/// edge.
struct Lettering {
  std::vector<Segment> strokes;
  int width = 0;
};

/// Printable ASCII and the middle dot, the multiplication sign and the ellipsis have glyphs of their own; any
/// other letter, and a byte that is no UTF-8, is a box.
Lettering lettering(std::string_view text);

}  // namespace pathrace::results
