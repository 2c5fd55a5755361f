// A random spanning tree over the cells of a coarse lattice: which neighbours are joined.
//
// Depth-first with backtracking, the classic maze generator: long winding corridors, few short dead ends.
#pragma once

#include <cstdint>
#include <vector>

#include "core/stream.hpp"

namespace pathrace::scenarios {

/// A rows x columns lattice; node k = row * columns + column.
class SpanningTree {
 public:
  SpanningTree(int columns, int rows, Stream& stream);

  /// Is the node joined to its right, to its lower neighbour? False at the lattice's edge.
  bool opens_right(int column, int row) const { return (doors_[node(column, row)] & 1U) != 0; }
  bool opens_down(int column, int row) const { return (doors_[node(column, row)] & 2U) != 0; }

 private:
  std::size_t node(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }

  int columns_;
  std::vector<std::uint8_t> doors_;  // bit 0: right, bit 1: down
};

}  // namespace pathrace::scenarios
