// Dead ends of a colony: from the steps that ants took back to steps that nobody takes again.
#pragma once

#include <cstddef>
#include <optional>

#include "algorithms/aco/colony.hpp"
#include "algorithms/aco/dead_cells.hpp"
#include "algorithms/aco/live_moves.hpp"

namespace pathrace::algorithms {

class DeadEnds {
 public:
  DeadEnds(const Problem& problem, DeadTable table, DeadCells::Layer layer);

  /// Does the table need to know which steps were taken back?
  bool global() const { return cells_.has_value(); }

  /// Marks the cells that the first `count` ants of the colony stepped back from, in ant order and each ant's
  /// own order, and closes the steps that this costs. Papers mark at once, while other ants walk.
  void mark(Colony& colony, std::size_t count);

 private:
  void close_around(Colony& colony, std::size_t cell) const;

  std::optional<LiveMoves> moves_;
  std::optional<DeadCells> cells_;
};

}  // namespace pathrace::algorithms
