// Exact lattice distances from one cell to every other.
//
// R. Dial's bucket queue ("Algorithm 360", CACM 12(11), 1969) with buckets one cell edge wide: no step is
// shorter, so whatever lies in the lowest bucket is final and may be taken in any order. Lengths are integer
// counts of straight and diagonal steps, compared exactly and put into buckets exactly.
//
// 13 bytes per padded cell.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/scenario.hpp"

namespace pathrace::reference {

/// The length rounded down, exactly. Neither count is negative or above 2^30.
std::int64_t whole_part(LatticeLength length);

class DistanceField {
 public:
  /// Searches from the free cell `source`, through the whole map or until `target` is final.
  DistanceField(const Terrain& terrain, Cell source, std::optional<Cell> target = std::nullopt);

  /// The shortest length from the source; empty where the search did not come. The cell lies on the map.
  std::optional<LatticeLength> length(Cell cell) const { return length_at(grid_.index(cell)); }
  std::optional<LatticeLength> length_at(std::size_t padded_index) const {
    const Count count = best_[padded_index];
    if (count.straight < 0) return std::nullopt;
    return LatticeLength{count.straight, count.diagonal};
  }

  /// Padded indices of the final cells, the source first. A cell comes after all that lie a step or more
  /// nearer to the source: its predecessors on shortest paths among them.
  const std::vector<std::uint32_t>& order() const { return order_; }

  /// Calls `visit(neighbour, diagonal)` for each legal step from the cell with this padded index.
  template <typename Visit>
  void for_each_step(std::size_t index, const Visit& visit) const {
    const std::size_t stride = grid_.stride();
    const std::size_t up = index - stride;
    const std::size_t down = index + stride;
    const std::size_t left = index - 1;
    const std::size_t right = index + 1;
    for (const std::size_t side : {up, down, left, right}) {
      if (!grid_.blocked_at(side)) visit(side, false);
    }
    if (rule_ == MoveRule::four) return;
    const int needed = rule_ == MoveRule::strict ? 2 : rule_ == MoveRule::squeeze ? 1 : 0;
    for (const std::size_t vertical : {up, down}) {
      for (const std::size_t horizontal : {left, right}) {
        const std::size_t corner = vertical + horizontal - index;
        const int free_sides = (grid_.blocked_at(vertical) ? 0 : 1) + (grid_.blocked_at(horizontal) ? 0 : 1);
        if (!grid_.blocked_at(corner) && free_sides >= needed) visit(corner, true);
      }
    }
  }

 private:
  struct Count {
    std::int32_t straight = -1;  // -1: not reached
    std::int32_t diagonal = 0;
  };
  static constexpr std::size_t bucket_count = 3;  // a step of sqrt 2 ends at most two buckets further

  void search(std::size_t source, std::size_t target);
  void reach(std::size_t index, Count count);
  void settle(std::size_t index);

  const OccupancyGrid& grid_;
  MoveRule rule_;
  std::vector<Count> best_;
  std::vector<std::uint8_t> settled_;
  std::array<std::vector<std::uint32_t>, bucket_count> buckets_;
  std::vector<std::uint32_t> order_;
};

}  // namespace pathrace::reference
