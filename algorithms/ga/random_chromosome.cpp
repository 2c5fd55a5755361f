#include "algorithms/ga/random_chromosome.hpp"

#include <algorithm>
#include <utility>

namespace pathrace::algorithms {

RandomChromosome::RandomChromosome(const GeneMap& map, std::size_t most)
    : start_(map.start()),
      goal_(map.goal()),
      most_(most == 0 ? map.inner().size() : std::min(most, map.inner().size())),
      urn_(map.inner()) {
  swaps_.reserve(most_);
}

// The first steps of a Fisher-Yates shuffle; undone afterwards, so that an urn gives the same cells whatever
// was drawn from it before.
void RandomChromosome::draw(Stream& stream, std::vector<Gene>& genes) {
  const auto count = static_cast<std::size_t>(stream.below(most_ + 1));
  genes.clear();
  genes.push_back(start_);
  swaps_.clear();
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t j = i + static_cast<std::size_t>(stream.below(urn_.size() - i));
    std::swap(urn_[i], urn_[j]);
    swaps_.push_back(j);
    genes.push_back(urn_[i]);
  }
  for (std::size_t i = count; i > 0; --i) std::swap(urn_[i - 1], urn_[swaps_[i - 1]]);
  genes.push_back(goal_);
}

}  // namespace pathrace::algorithms
