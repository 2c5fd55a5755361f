#include "algorithms/ga/mutation.hpp"

#include <algorithm>
#include <cstdlib>
#include <optional>

namespace pathrace::algorithms {
namespace {

void replace_one(const GeneMap& map, Stream& stream, std::vector<Gene>& genes) {
  const std::size_t position = 1 + stream.below(genes.size() - 2);
  genes[position] = map.inner()[stream.below(map.inner().size())];
}

// A free cell in the box around two cells, grown on each side by half of the larger of its sides and one;
// nothing where the first cell drawn from it is blocked or outside the map.
std::optional<Gene> nearby(const GeneMap& map, Cell a, Cell b, Stream& stream) {
  const int margin = std::max(std::abs(a.x - b.x), std::abs(a.y - b.y)) / 2 + 1;
  const int x = stream.between(std::min(a.x, b.x) - margin, std::max(a.x, b.x) + margin);
  const int y = stream.between(std::min(a.y, b.y) - margin, std::max(a.y, b.y) + margin);
  return map.free_cell({x, y});
}

void redraw_stretch(const GeneMap& map, Stream& stream, std::vector<Gene>& genes) {
  const auto begin = static_cast<std::size_t>(stream.below(genes.size() - 2));
  const std::uint64_t longest = 1 + stream.below(genes.size() - 2 - begin);
  const auto end = begin + 2 + static_cast<std::size_t>(stream.below(longest));
  const bool through = stream.chance(0.5);
  const auto at = [&](std::size_t i) { return genes.begin() + static_cast<std::ptrdiff_t>(i); };
  if (through) {
    const auto via = nearby(map, map.cell(genes[begin]), map.cell(genes[end]), stream);
    if (via) {
      genes[begin + 1] = *via;
      genes.erase(at(begin + 2), at(end));
      return;
    }
  }
  genes.erase(at(begin + 1), at(end));
}

}  // namespace

void mutate(const GeneMap& map, Mutation kind, Stream& stream, std::vector<Gene>& genes) {
  if (genes.size() < 3 || map.inner().empty()) return;
  switch (kind) {
    case Mutation::replace: return replace_one(map, stream, genes);
    case Mutation::stretch: return redraw_stretch(map, stream, genes);
  }
}

}  // namespace pathrace::algorithms
