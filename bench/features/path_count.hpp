// The number of shortest paths of a scenario, which may need more digits than any integer has.
//
// A count is mantissa * 2^(512 * exponent). Below 2^53 it is exact. Above, each sum rounds as doubles do;
// powers of two are exact, and cells are summed in one order, so that the bits are the same everywhere.
#pragma once

#include <cstdint>

#include "core/cell.hpp"
#include "core/grid.hpp"
#include "core/reference/distance_field.hpp"

namespace pathrace::bench {

struct PathCount {
  double mantissa = 0;        ///< 0, or 1 <= mantissa < 2^512
  std::int64_t exponent = 0;  ///< of 2^512

  void add(PathCount other);
  /// log10 of the count, which is not 0; from sums and products alone, so with the same bits everywhere.
  double log10() const;
};

/// The number of distinct shortest paths from the field's source to a cell whose distance is final; each
/// path is a sequence of cells. Dynamic programming: a cell has as many as its predecessors together.
PathCount count_shortest_paths(const reference::DistanceField& field, const OccupancyGrid& grid, Cell cell);

}  // namespace pathrace::bench
