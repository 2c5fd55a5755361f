// Splicing: a path learns from another one by taking over the rest of it at a cell that both visit.
//
// Of all cells that two paths share, the one is chosen at which "the learner until there, the teacher from
// there on" is shortest; ties go to the cell nearest to the start. The result visits no cell twice: a cell
// before the joint on the learner and behind it on the teacher would be a shorter joint itself.
//
// Our reading of the paper's teaching for paths, algorithms.md 3.5 (B).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "algorithms/aco/walk.hpp"

namespace pathrace::algorithms {

/// Scratch memory for one map; not shared between threads.
class Splicer {
 public:
  /// For walks on this nest, which outlives the splicer.
  explicit Splicer(const Nest& nest) : nest_(nest), visits_(nest.size()) {}

  /// Both walks have arrived and visit no cell twice. True when the learner has another path now, a shorter
  /// one; else it is as it was.
  bool improve(Walk& learner, const Walk& teacher);

 private:
  /// When a walk comes to a cell.
  struct Visit {
    std::uint32_t place = 0;      ///< from 1; 0: never
    std::uint32_t diagonals = 0;  ///< steps of this kind before
  };
  struct Joint {
    std::size_t on_learner = 0;  ///< steps before it
    std::size_t on_teacher = 0;
    LatticeLength length;  ///< of the path that it makes
  };

  std::optional<Joint> shortest_joint(const Walk& learner, const Walk& teacher) const;

  const Nest& nest_;
  std::vector<Visit> visits_;  // of the teacher; none between calls
};

}  // namespace pathrace::algorithms
