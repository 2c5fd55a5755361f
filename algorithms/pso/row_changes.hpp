// Walls, for eight segments abreast: what WallMap counts, looked up where a segment goes from row to row.
//
// Let P[r][c] be the blocked cells of row r before column c. A segment that runs to the right, enters row r
// in column a and leaves it in column b meets P[r][b + 1] - P[r][a] of them. Over all its rows, the two terms
// that belong to one change of rows, from r to r' in column c, make one number,
//
//   P[r][c + 1] - P[r'][c],
//
// which a table holds for r' = r + 1 and another one for r' = r - 1; beside them only P where the segment
// begins and ends remains. The cells that it enters are counted alike, as those of a map without a free cell.
//
// Where rows change is computed in 32 bits, too few to tell a corner of cells from a place close to it. So
// this is a filter: a segment that changes rows close to a line between columns, that ends on a line, or that
// has no length is unsure, and left to WallMap. All others keep away from every corner by more than the
// errors, so that their counts are exact.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/grid.hpp"

namespace pathrace::algorithms {

class RowChanges {
 public:
  static constexpr std::size_t lanes = 8;
  /// The longest side of a map: a place in it, with its frame, has 6 binary digits before the point.
  static constexpr int most_cells = 62;

  /// Points abreast, in ticks (wall_map.hpp).
  struct Points {
    std::array<std::int32_t, lanes> x;
    std::array<std::int32_t, lanes> y;
  };
  /// What the segments of each lane have met.
  struct Sums {
    std::array<std::uint32_t, lanes> walls{};
    std::array<std::uint32_t, lanes> cells{};
  };

  static bool cover(const OccupancyGrid& grid) {
    return grid.width() <= most_cells && grid.height() <= most_cells;
  }
  /// Of a map that is covered.
  explicit RowChanges(const OccupancyGrid& grid);

  /// The segment of a lane leads from its point of `from` to its point of `to`, inside the map or on its
  /// border. Adds what it meets to its sums, unless it is unsure. Returns the lanes that are: bit k for lane
  /// k.
  std::uint32_t cross(const Points& from, const Points& to, Sums& sums) const;

 private:
  void fill(const OccupancyGrid& grid, bool transposed);

  std::int32_t side_;  // rows, and columns, of a plane: of the longer side of the map, its frame, and one
  std::int32_t size_;  // entries of a plane
  // Cells * 2^16 + walls. Entry 0 is zero, for lanes with nothing to add. Then planes, row by row: changes
  // downwards and upwards, of the map and of the transposed map; P of the map and of the transposed map.
  std::vector<std::int32_t> table_;
};

}  // namespace pathrace::algorithms
