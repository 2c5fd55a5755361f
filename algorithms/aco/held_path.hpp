// The strengths along a path, held together while the same path is deposited on again and again.
//
// Ants of a colony that has converged bring the same path home, one after another. From the second time on,
// its strengths stand side by side, where a vector instruction adds to eight at once; they go back to their
// rows when another path comes. Each strength sees the same additions in the same order, hence the same bits.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "algorithms/aco/trail_row.hpp"

namespace pathrace::algorithms {

class HeldPath {
 public:
  /// For paths over this many rows.
  explicit HeldPath(std::size_t rows) : seen_(rows, 0) {}

  /// A path comes: from row `from` on, with the steps back or without. True when it is the one that came
  /// last, and its strengths are held: `add` adds to them. False when its rows are to be added to: it is
  /// another, and what was held is back in its rows; or it comes to a row twice, and cannot be held.
  bool comes(TrailRow* rows, const RowSteps& steps, std::size_t from,
             std::span<const std::uint8_t> directions, bool both_ways);
  /// strength := min(max(strength, least) + added, most) for all that are held.
  void add(float added, float least, float most);
  /// What was held goes back to its rows; the next path is another.
  void end();
  /// What was held is lost; the next path is another.
  void drop();

 private:
  bool hold(TrailRow* rows, const RowSteps& steps);
  void put_back();

  std::size_t from_ = 0;
  std::vector<std::uint8_t> directions_;
  bool both_ways_ = false;
  bool known_ = false;  // there is a last path
  bool held_ = false;
  std::vector<float> strengths_;    // of the path, when held
  std::vector<float*> where_;       // in the rows each of them belongs
  std::vector<std::uint8_t> seen_;  // a byte per row; 0 between calls
};

}  // namespace pathrace::algorithms
