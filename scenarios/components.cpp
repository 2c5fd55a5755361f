#include "scenarios/components.hpp"

#include <algorithm>
#include <cstddef>

namespace pathrace::scenarios {
namespace {

std::vector<std::size_t> neighbour_offsets(std::size_t stride, MoveRule rule) {
  std::vector<std::size_t> offsets = {0 - stride, stride, std::size_t{0} - 1, 1};  // wrap around
  if (rule == MoveRule::free) {
    for (const std::size_t corner : {0 - stride - 1, 0 - stride + 1, stride - 1, stride + 1}) {
      offsets.push_back(corner);
    }
  }
  return offsets;
}

}  // namespace

Regions::Regions(const OccupancyGrid& grid, MoveRule rule)
    : stride_(grid.stride()), label_(grid.padded_size(), 0), sizes_(1, 0) {
  const std::vector<std::size_t> offsets = neighbour_offsets(stride_, rule);
  const auto is_new = [&](std::size_t index) { return !grid.blocked_at(index) && label_[index] == 0; };
  std::vector<std::uint32_t> open;
  for (std::size_t seed = 0; seed < label_.size(); ++seed) {
    if (!is_new(seed)) continue;
    const auto label = static_cast<std::uint32_t>(sizes_.size());
    sizes_.push_back(0);
    label_[seed] = label;
    open.assign(1, static_cast<std::uint32_t>(seed));
    while (!open.empty()) {
      const std::size_t index = open.back();
      open.pop_back();
      ++sizes_[label];
      for (const std::size_t offset : offsets) {
        const std::size_t next = index + offset;
        if (!is_new(next)) continue;
        label_[next] = label;
        open.push_back(static_cast<std::uint32_t>(next));
      }
    }
  }
}

std::vector<Cell> Regions::largest() const {
  const auto most = std::max_element(sizes_.begin(), sizes_.end());  // the first of equals
  std::vector<Cell> cells;
  if (*most == 0) return cells;
  const auto label = static_cast<std::uint32_t>(most - sizes_.begin());
  cells.reserve(*most);
  for (std::size_t index = 0; index < label_.size(); ++index) {
    if (label_[index] != label) continue;
    cells.push_back({static_cast<int>(index % stride_) - 1, static_cast<int>(index / stride_) - 1});
  }
  return cells;
}

std::vector<Cell> largest_region(const OccupancyGrid& grid) {
  return Regions(grid).largest();
}

}  // namespace pathrace::scenarios
