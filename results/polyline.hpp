// A path as a line to draw.
#pragma once

#include <vector>

#include "core/cell.hpp"

namespace pathrace::results {

/// The corners alone: a straight run needs its two ends. Points that are not finite are left out.
std::vector<Point> corners_of(const std::vector<Point>& points);

double polyline_length(const std::vector<Point>& points);

}  // namespace pathrace::results
