// Free space: may a point be here, may it go straight from here to there?
//
// The any-angle rule, on the safe side of every tie. A blocked cell, and each cell outside the map, is taken
// as its square grown by `margin` on every side, edges included: what this calls free keeps at least that far
// away from the open squares, so that it neither touches a corner nor runs along an edge, however the sums
// are rounded. With coordinates below 2^15 the sums are exact to about 1e-11, far below the margin.
//
// A segment is walked along its longer axis, one column (or row) of cells at a time: the piece of it inside
// the column spans at most a few cells, and each of them must be free. Nothing is sampled, and nothing is
// missed.
#pragma once

#include <cstdint>

#include "core/cell.hpp"
#include "core/grid.hpp"

namespace pathrace::baselines {

class FreeSpace {
 public:
  static constexpr double margin = 1e-9;

  /// What an answer cost: cells tested, at most the limit. An answer that the limit cut is "not free".
  struct Look {
    bool free = false;
    std::uint64_t cells = 0;
  };

  explicit FreeSpace(const OccupancyGrid& grid);

  /// Ends of the plane that a point may be in: the map's, less the margin.
  double low() const { return -0.5 + 2 * margin; }
  double high_x() const { return grid_.width() - 0.5 - 2 * margin; }
  double high_y() const { return grid_.height() - 0.5 - 2 * margin; }

  Look at(Point point, std::uint64_t limit) const;
  Look along(Point from, Point to, std::uint64_t limit) const;

  /// How far one gets from a free point towards another that cannot be reached straight: a fraction below 1
  /// of the way, at which the point and all before it are free; 0 when in doubt.
  double reach(Point from, Point to) const;

 private:
  bool inside(Point point) const {  // false for NaN
    return point.x >= low() && point.y >= low() && point.x <= high_x() && point.y <= high_y();
  }

  const OccupancyGrid& grid_;
};

}  // namespace pathrace::baselines
