// Discs as a grid: what a planner of static maps sees of a snapshot.
#pragma once

#include "core/navigator.hpp"
#include "core/scenario.hpp"

namespace pathrace::baselines {

/// Cell (x, y) covers the square of side `resolution` whose upper left corner is (x, y) * resolution.
class DiscMap {
 public:
  /// Blocks each cell whose centre the robot's centre may not reach: nearer to a disc's centre than the sum
  /// of the radii and `margin` cells, or nearer to the border than its radius. The cells of robot and goal
  /// stay free. The rule is `strict`.
  DiscMap(const Snapshot& snapshot, double resolution, double margin);

  const Terrain& terrain() const { return terrain_; }
  Cell cell_of(Point point) const;
  /// Of a path's point, in the snapshot's units.
  Point place_of(Point cells) const;

 private:
  double resolution_;
  int width_;
  int height_;
  Terrain terrain_;
};

}  // namespace pathrace::baselines
