// The smallest circle around a set of points, and the convex hull that it depends on.
//
// A circle encloses a set when it encloses the corners of its hull. Points are taken in random order; one
// that lies outside the circle so far must lie on the border of the new one, which leaves a smaller problem
// of the same kind: expected linear time.
//
// E. Welzl, "Smallest enclosing disks (balls and ellipsoids)", LNCS 555, 1991. Hull: A. M. Andrew,
// Information Processing Letters 9(5), 1979.
#pragma once

#include <vector>

#include "core/cell.hpp"
#include "core/stream.hpp"

namespace pathrace::algorithms {

struct Circle {
  Point centre;
  double radius = 0;  ///< in cell edges

  friend bool operator==(const Circle&, const Circle&) = default;
};

/// The corners of the convex hull, counter-clockwise in a frame with y upwards, without collinear points.
/// Points with coordinates that are multiples of 1/2 below 2^24 are treated exactly.
std::vector<Point> convex_hull(std::vector<Point> points);

/// The smallest circle around the points; radius 0 for a single one. The radius is the largest distance from
/// the centre as computed, so that every point satisfies distance <= radius. Expects at least one point.
Circle smallest_enclosing_circle(std::vector<Point> points, Stream order);

}  // namespace pathrace::algorithms
