// The strengths along a path, held together while the same path is deposited on again and again.
//
// Ants of a colony that has converged bring the same path home, one after another. From the second time on,
// its strengths stand side by side, where a vector instruction adds to many at once; they go back to their
// rows when another path comes. Each strength sees the same additions in the same order, hence the same bits.
#pragma once

#include <algorithm>
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
             std::span<const std::uint8_t> directions, bool both_ways) {
    const bool again =
        known_ && from == from_ && both_ways == both_ways_ &&
        std::equal(directions.begin(), directions.end(), directions_.begin(), directions_.end());
    return again ? held_ || hold(rows, steps) : another_comes(from, directions, both_ways);
  }
  /// strength := min(max(strength, least) + added, most) for all that are held.
  void add(float added, float least, float most);
  /// What was held goes back to its rows; the next path is another.
  void end();
  /// What was held is lost; the next path is another.
  void drop();

 private:
  static constexpr std::size_t in_a_block = 16;
  // A vector of g++ and clang, for any processor.
  using Strengths = float __attribute__((vector_size(in_a_block * sizeof(float))));
  struct Block {
    Strengths strengths;
  };

  bool another_comes(std::size_t from, std::span<const std::uint8_t> directions, bool both_ways);
  bool hold(TrailRow* rows, const RowSteps& steps);
  void put_back();

  std::size_t from_ = 0;
  std::vector<std::uint8_t> directions_;
  bool both_ways_ = false;
  bool known_ = false;  // there is a last path
  bool held_ = false;
  std::vector<Block> blocks_;       // the strengths of the path, when held
  std::vector<float*> where_;       // in the rows each of them belongs
  std::vector<std::uint8_t> seen_;  // a byte per row; 0 between calls
};

}  // namespace pathrace::algorithms
