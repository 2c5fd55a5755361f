// The free space of a map as rows of runs: maximal stretches of free cells.
//
// Coordinates are doubled, so that everything is an integer: cell (x, y) is the square around (2 x, 2 y) with
// its corners at odd coordinates.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/cell.hpp"
#include "core/grid.hpp"

namespace pathrace::baselines {

/// A place in doubled coordinates.
struct Spot {
  int x = 0;
  int y = 0;

  friend bool operator==(const Spot&, const Spot&) = default;
};

/// Stretches from `left` to `right` in doubled coordinates, both odd, walls not included.
struct FreeRun {
  int left;
  int right;
};

class FreeRuns {
 public:
  explicit FreeRuns(const OccupancyGrid& grid);

  int rows() const { return static_cast<int>(first_in_row_.size()) - 1; }
  const FreeRun& operator[](std::size_t run) const { return runs_[run]; }
  /// Past the last run of a row.
  std::size_t end_of(int row) const { return first_in_row_[static_cast<std::size_t>(row) + 1]; }
  /// The run that holds this cell; for a blocked cell the next to its right, or the row's end.
  std::size_t at_or_after(int column, int row) const {
    return at_or_after_[static_cast<std::size_t>(row) * width_ + static_cast<std::size_t>(column)];
  }

 private:
  std::size_t width_;
  std::vector<FreeRun> runs_;
  std::vector<std::size_t> first_in_row_;
  std::vector<std::uint32_t> at_or_after_;
};

}  // namespace pathrace::baselines
