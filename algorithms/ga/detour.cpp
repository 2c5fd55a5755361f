#include "algorithms/ga/detour.hpp"

#include <algorithm>
#include <array>

#include "core/checkpoint.hpp"

namespace pathrace::algorithms {
namespace {

using Order = std::array<int, direction_count>;

// Straight steps first, so that a way out bends less; the second is the first in a mirror.
constexpr std::array<Order, 2> orders = {{{0, 2, 4, 6, 1, 3, 5, 7}, {6, 4, 2, 0, 7, 5, 3, 1}}};

std::int64_t squared_distance(Cell a, Cell b) {
  const std::int64_t dx = a.x - b.x;
  const std::int64_t dy = a.y - b.y;
  return dx * dx + dy * dy;
}

}  // namespace

Detour::Detour(const GeneMap& map, std::size_t reach)
    : map_(map), reach_(reach), seen_(filled_gradually<std::vector<std::uint32_t>>(map.size(), 0)) {
  const std::size_t most = std::min(map.inner().size() + 2, 8 * reach + 1);
  queue_.reserve(most);
  way_.reserve(most);
}

void Detour::clear() {
  queue_.clear();
  way_.clear();
  expanded_ = 0;
  if (++tag_ != 0) return;
  std::fill(seen_.begin(), seen_.end(), 0U);  // the tags are used up
  tag_ = 1;
}

bool Detour::enter(Gene gene, std::size_t parent) {
  if (seen_[gene] == tag_) return false;
  seen_[gene] = tag_;
  queue_.push_back({gene, static_cast<std::uint32_t>(parent)});
  return true;
}

void Detour::trace_back(std::size_t node) {
  for (; node != 0; node = queue_[node].parent) way_.push_back(queue_[node].gene);
  std::reverse(way_.begin(), way_.end());
}

const std::vector<Gene>& Detour::search(Gene from, Gene target, std::uint64_t limit, Stream& stream) {
  clear();
  const Order& order = orders[stream.bits() >> 63];
  const Cell there = map_.cell(target);
  const std::int64_t least = squared_distance(map_.cell(from), there);
  const std::uint64_t most = std::min<std::uint64_t>(reach_, limit);
  enter(from, 0);
  for (std::size_t head = 0; head < queue_.size() && expanded_ < most; ++head) {
    ++expanded_;
    const Gene gene = queue_[head].gene;
    for (const int d : order) {
      if ((map_.legal(gene) >> d & 1U) == 0) continue;
      const Gene next = map_.step(gene, d);
      if (!enter(next, head) || squared_distance(map_.cell(next), there) >= least) continue;
      trace_back(queue_.size() - 1);
      return way_;
    }
  }
  return way_;
}

}  // namespace pathrace::algorithms
