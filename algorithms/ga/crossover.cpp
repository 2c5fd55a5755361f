#include "algorithms/ga/crossover.hpp"

namespace pathrace::algorithms {

std::optional<Cut> Crossover::cut(std::span<const Gene> first, std::span<const Gene> second, Stream& stream) {
  if (first.size() < 3 || second.size() < 3) return std::nullopt;
  if (point_ == CrossoverPoint::common) {
    places_.clear();
    shared_.clear();
    for (std::size_t i = 1; i + 1 < first.size(); ++i) places_.set(first[i], i);
    for (std::size_t j = 1; j + 1 < second.size(); ++j) {
      const std::uint32_t i = places_.find(second[j]);
      if (i != PlaceTable::nowhere) shared_.push_back({i, j});
    }
    if (!shared_.empty()) return shared_[stream.below(shared_.size())];
  }
  const std::size_t i = 1 + stream.below(first.size() - 2);
  const std::size_t j = 1 + stream.below(second.size() - 2);
  return Cut{i, j};
}

}  // namespace pathrace::algorithms
