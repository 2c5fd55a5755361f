// Random chromosomes: the start, a random number of different free cells in random order, the goal.
//
// Xie, Yu, 2010, section 2.2: length and genes are random; the length is uniform from 0 inner genes to all
// free cells, or to a given number [I].
#pragma once

#include <cstddef>
#include <vector>

#include "algorithms/ga/gene_map.hpp"
#include "core/stream.hpp"

namespace pathrace::algorithms {

/// Draws without replacement from a map's inner cells. Not for use by two threads at once.
class RandomChromosome {
 public:
  /// At most `most` inner genes; 0: as many as there are.
  RandomChromosome(const GeneMap& map, std::size_t most);

  void draw(Stream& stream, std::vector<Gene>& genes);

 private:
  Gene start_;
  Gene goal_;
  std::size_t most_;
  std::vector<Gene> urn_;
  std::vector<std::size_t> swaps_;
};

}  // namespace pathrace::algorithms
