// A detour: the short local search that leads out of a corner.
//
// From a cell where the straight way to a target ends, breadth first over legal steps to the first cell that
// is nearer to the target (straight distance), at most `reach` cells expanded. Not the shortest way to the
// target, only the nearest way out; what it costs in length is left to evolution.
//
// J. Hoffmann, B. Nebel, "The FF Planning System", JAIR 14, 2001: enforced hill-climbing.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "algorithms/ga/gene_map.hpp"
#include "core/stream.hpp"

namespace pathrace::algorithms {

/// Scratch memory for one map; not for use by two threads at once.
class Detour {
 public:
  Detour(const GeneMap& map, std::size_t reach);

  /// Cells from behind `from` to the first that is nearer to `target`; empty when there is none within reach.
  /// Draws once: on which hand it looks first. At most `limit` cells are expanded.
  const std::vector<Gene>& search(Gene from, Gene target, std::uint64_t limit, Stream& stream);
  /// Cells that the last search expanded.
  std::uint64_t expanded() const { return expanded_; }

 private:
  struct Node {
    Gene gene = 0;
    std::uint32_t parent = 0;  // in the queue
  };

  void clear();
  bool enter(Gene gene, std::size_t parent);
  void trace_back(std::size_t node);

  const GeneMap& map_;
  std::size_t reach_;
  std::vector<Node> queue_;
  std::vector<std::uint32_t> seen_;  // tag of the last search that met the cell
  std::uint32_t tag_ = 0;
  std::uint64_t expanded_ = 0;
  std::vector<Gene> way_;
};

}  // namespace pathrace::algorithms
