// Walls, for segments at any angle: which blocked cells does a segment enter, exactly?
//
// A blocked cell is the open square of side 1 around its centre. A segment may touch its edge or corner, may
// not enter it, may not run along the edge that two blocked cells share, and may not pass the corner where
// two blocked cells touch while the other two are free. What lies outside the map is blocked.
//
// Coordinates are whole multiples of 1/1024 cell ("ticks") from the upper left corner of the frame of blocked
// cells around the map: cell (x, y) reaches from tick 1024 (x + 1) to 1024 (x + 2). Every decision is then
// exact: numerators stay below 2^53, and a quotient that is no whole number is further from one than the
// error of its division.
//
// Encoding: a bit per cell, row by row. A segment crosses a row of cells in one interval, whose blocked cells
// are counted a word at a time. Segments steeper than 45 degrees go over the transposed map, so that they
// have few rows, too. On small maps several segments abreast are looked up where they go from row to row
// (row_changes.hpp); only those that come too close to a line for that go row by row.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "algorithms/pso/row_changes.hpp"
#include "core/cell.hpp"
#include "core/grid.hpp"

namespace pathrace::algorithms {

/// A point in ticks.
struct Tick {
  std::int32_t x = 0;
  std::int32_t y = 0;

  friend bool operator==(const Tick&, const Tick&) = default;
};

inline constexpr int ticks_per_cell = 1024;

constexpr Tick tick_of(Cell cell) {
  return {(2 * cell.x + 3) * (ticks_per_cell / 2), (2 * cell.y + 3) * (ticks_per_cell / 2)};
}
constexpr Point point_of(Tick tick) {
  constexpr double cell = ticks_per_cell;
  return {tick.x / cell - 1.5, tick.y / cell - 1.5};
}

/// What a segment meets.
struct Crossing {
  std::uint32_t walls = 0;  ///< blocked cells entered, closed corners passed, shared edges run along
  std::uint32_t cells = 0;  ///< cells tested

  friend bool operator==(const Crossing&, const Crossing&) = default;
};

class WallMap {
 public:
  explicit WallMap(const OccupancyGrid& grid);

  /// Both ends inside the map or on its border. A segment without length meets nothing.
  Crossing cross(Tick from, Tick to) const;
  /// Segments abreast: adds what those of lanes 0..count-1 meet to their sums.
  void cross(const RowChanges::Points& from, const RowChanges::Points& to, std::size_t count,
             RowChanges::Sums& sums) const;

 private:
  // The map as its rows; the transposed map has the columns for rows.
  class Rows {
   public:
    Rows(const OccupancyGrid& grid, bool transposed);
    Crossing slope(Tick upper, Tick lower) const;
    Crossing level(std::int32_t low, std::int32_t high, std::int32_t y) const;

   private:
    using Bits = std::vector<std::uint64_t>;
    void set(Bits& bits, std::int64_t row, std::int64_t column) const;
    std::uint32_t bit(const Bits& bits, std::int64_t row, std::int64_t column) const;
    std::uint32_t count(const Bits& bits, std::int64_t row, std::int64_t first, std::int64_t last) const;
    std::uint32_t corner(Tick tick) const;
    Crossing slope_narrow(Tick upper, Tick lower) const;
    Crossing slope_wide(Tick upper, Tick lower) const;

    std::int64_t width_;  // with the frame
    std::int64_t height_;
    std::int64_t words_;  // per row
    Bits blocked_;        // bit c of row r: that cell
    Bits seams_;          // bit c of row r: cells c of rows r - 1 and r
    Bits corners_;        // bit c of row r: the upper left corner of that cell is closed
  };

  Crossing cross_level(Tick from, Tick to) const;

  Rows rows_;
  Rows columns_;
  std::optional<RowChanges> changes_;  // of a map that they cover
};

}  // namespace pathrace::algorithms
