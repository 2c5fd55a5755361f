// Occupancy grid: which cells a point robot may occupy.
//
// One byte per cell, row by row, inside a frame of blocked cells one cell wide, so that looking at the
// eight neighbours of any cell of the map needs no bounds check. The padded index of cell (x, y) is
// (y + 1) * stride + (x + 1) with stride = width + 2.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/cell.hpp"

namespace pathrace {

class OccupancyGrid {
 public:
  static constexpr int max_side = 16384;
  static constexpr std::int64_t max_cells = std::int64_t{1} << 27;

  /// A grid of free cells. Throws InvalidScenario outside 1..max_side per side or above max_cells.
  OccupancyGrid(int width, int height);

  int width() const { return width_; }
  int height() const { return height_; }
  bool contains(Cell cell) const { return cell.x >= 0 && cell.y >= 0 && cell.x < width_ && cell.y < height_; }
  /// False for blocked cells and for every cell outside the map.
  bool is_free(Cell cell) const { return contains(cell) && blocked_[index(cell)] == 0; }
  std::int64_t free_cells() const;

  /// Both throw InvalidScenario for a cell outside the map.
  void block(Cell cell) { set(cell, 1); }
  void clear(Cell cell) { set(cell, 0); }

  std::size_t stride() const { return stride_; }
  std::size_t padded_size() const { return blocked_.size(); }
  std::size_t index(Cell cell) const {
    return static_cast<std::size_t>(cell.y + 1) * stride_ + static_cast<std::size_t>(cell.x + 1);
  }
  Cell cell(std::size_t index) const {
    return {static_cast<int>(index % stride_) - 1, static_cast<int>(index / stride_) - 1};
  }
  bool blocked_at(std::size_t index) const { return blocked_[index] != 0; }

  friend bool operator==(const OccupancyGrid&, const OccupancyGrid&) = default;

 private:
  void set(Cell cell, std::uint8_t value);

  int width_;
  int height_;
  std::size_t stride_;
  std::vector<std::uint8_t> blocked_;
};

}  // namespace pathrace
