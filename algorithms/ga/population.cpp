#include "algorithms/ga/population.hpp"

#include <algorithm>

namespace pathrace::algorithms {

void Population::copy(std::size_t i, const Individual& other, std::span<const Gene> genes) {
  individuals_[i] = other;
  std::copy(genes.begin(), genes.end(), slot(i).begin());
}

std::size_t Population::best(std::size_t count) const {
  std::size_t best = 0;
  for (std::size_t i = 1; i < count; ++i) {
    if (fitter(individuals_[i], individuals_[best])) best = i;
  }
  return best;
}

std::size_t Population::worst(std::size_t count) const {
  std::size_t worst = 0;
  for (std::size_t i = 1; i < count; ++i) {
    if (fitter(individuals_[worst], individuals_[i])) worst = i;
  }
  return worst;
}

}  // namespace pathrace::algorithms
