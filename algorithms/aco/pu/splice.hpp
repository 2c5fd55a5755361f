// Splicing: a path learns from another one by taking over the rest of it at a cell that both visit.
//
// Of all cells that two paths share, the one is chosen at which "the learner until there, the teacher from
// there on" is shortest; ties go to the cell nearest to the start. The result visits no cell twice: a cell
// before the joint on the learner and behind it on the teacher would be a shorter joint itself.
//
// Our reading of the paper's teaching for paths, algorithms.md 3.5 (B).
#pragma once

#include <cstdint>
#include <vector>

#include "core/lattice_length.hpp"

namespace pathrace::algorithms {

/// Padded indices of a lattice path's cells, from start to goal.
using CellPath = std::vector<std::uint32_t>;

/// Steps of one row or column are straight. `stride` is the grid's.
LatticeLength length_of(const CellPath& path, std::size_t stride);

/// Scratch memory for one map; not shared between threads.
class Splicer {
 public:
  Splicer(std::size_t padded_size, std::size_t stride) : place_(padded_size, 0), stride_(stride) {}

  /// Both paths run from the same start to the same goal, so the goal is always shared; each visits no cell
  /// twice. Returns the learner itself when no joint is shorter.
  CellPath splice(const CellPath& learner, const CellPath& teacher);

 private:
  std::vector<std::uint32_t> place_;  // position on a path from 1; all 0 between calls
  std::size_t stride_;
};

}  // namespace pathrace::algorithms
