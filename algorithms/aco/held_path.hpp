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
  HeldPath() = default;
  /// For paths over this many rows.
  explicit HeldPath(std::size_t rows) : seen_(rows, 0) {}

  /// True when the last path was this one: from row `from` on, with the steps back or without.
  bool is(std::size_t from, std::span<const std::uint8_t> directions, bool both_ways) const;
  /// Another path comes: what was held goes back to its rows.
  void change_to(std::size_t from, std::span<const std::uint8_t> directions, bool both_ways);
  /// Takes the last path's strengths out of the rows, if they are not held yet. False when that cannot be
  /// done, because the path comes to a row twice.
  bool hold(TrailRow* rows, const RowSteps& steps);
  /// strength := min(max(strength, least) + added, most) for all that are held.
  void add(float added, float least, float most);
  /// What was held goes back to its rows; there is no last path any more.
  void end();
  /// There is no last path any more; what was held is lost.
  void drop();

 private:
  bool is_simple(const TrailRow* rows, const RowSteps& steps);
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
