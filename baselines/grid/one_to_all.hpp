// Exact distances from one cell to all others, by Dijkstra's algorithm on buckets; for any number of sources
// on one map, without allocation after the first.
#pragma once

#include "baselines/grid/grid_search.hpp"

namespace pathrace::baselines {

class OneToAll {
 public:
  /// The terrain outlives this; its map has at most 2^24 cells.
  explicit OneToAll(const Terrain& terrain) : search_(terrain) {}

  /// Measures from this free cell.
  void measure(Cell source) { search_.flood(source); }

  /// The least length from the source of the last measurement; nothing where there is no way. The cell lies
  /// on the map.
  std::optional<LatticeLength> distance(Cell cell) const { return search_.distance(cell); }

 private:
  GridSearch<ZeroDistance> search_;
};

}  // namespace pathrace::baselines
