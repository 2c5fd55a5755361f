// The nest: the ground a colony walks on. Which steps are open, where the walks begin and end.
//
// Steps start as the move rule allows them. A cell may be closed to all ants later (a dead-end table): that
// is a layer of its own, so a closed cell does not take part in the corner rule as an obstacle would.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/moves.hpp"
#include "core/planner.hpp"

namespace pathrace::algorithms {

class Nest {
 public:
  explicit Nest(const Problem& problem);

  const MoveTable& moves() const { return moves_; }
  std::size_t stride() const { return stride_; }
  std::size_t size() const { return open_.size(); }
  std::size_t free_cells() const { return free_cells_; }
  /// Padded indices.
  std::size_t start() const { return start_; }
  std::size_t goal() const { return goal_; }

  /// Bit d is set when the step in direction d is legal and leads to no closed cell.
  std::uint8_t open(std::size_t index) const { return open_[index]; }
  bool closed(std::size_t index) const { return closed_[index] != 0; }
  /// No step leads to this cell any more. Start and goal stay open. Colony::close tells the trail too.
  void close(std::size_t index);
  /// Neither this step nor its reverse is open any more. Colony::close_step tells the trail too.
  void close_step(std::size_t index, int direction);

  Cell cell(std::size_t index) const {
    return {static_cast<int>(index % stride_) - 1, static_cast<int>(index / stride_) - 1};
  }

 private:
  MoveTable moves_;
  std::size_t stride_;
  std::size_t free_cells_;
  std::size_t start_;
  std::size_t goal_;
  std::vector<std::uint8_t> open_;
  std::vector<std::uint8_t> closed_;
};

}  // namespace pathrace::algorithms
