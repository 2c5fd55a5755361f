// Circles that cover the obstacles of a map: the environment of the pre-planned path.
//
// Each obstacle gets the smallest circle around the corners of its cells, so that the circle covers the cells
// and not just their centres. An irregular obstacle is "wrapped by several circles"; the paper gives no rule.
// Ours: while the circle's area is more than `area_ratio` times the area of the cells, halve the obstacle
// across the longer side of its bounding box.
//
// Tan et al., 3.3.1 (1); algorithms.md 2.1.
#pragma once

#include <vector>

#include "algorithms/aco/tan/components.hpp"
#include "algorithms/aco/tan/enclosing_circle.hpp"

namespace pathrace::algorithms {

struct CoverSettings {
  Neighbours neighbours = Neighbours::eight;
  double area_ratio = 2;  ///< a square cell alone has pi / 2, two in a row have 1.96
  int max_depth = 6;      ///< an obstacle becomes at most 2^max_depth circles
};

/// The circles of one obstacle, upper or left half first.
std::vector<Circle> cover(const Obstacle& obstacle, const CoverSettings& settings, const Stream& order);

/// The circles of all obstacles. Obstacle i draws from order.fork(i).
std::vector<Circle> cover(const OccupancyGrid& grid, const CoverSettings& settings, const Stream& order);

}  // namespace pathrace::algorithms
