#include "baselines/incremental/changing_map.hpp"

#include <algorithm>
#include <cassert>

namespace pathrace::baselines {
namespace {

constexpr std::size_t stretch = 64;  // cells compared at once

}  // namespace

ChangingMap::ChangingMap(const Terrain& terrain)
    : moves_(CanonicalMoves::of(terrain.rule)),
      blocked_(terrain.grid->padded_size()),
      neighbours_(free_neighbours(*terrain.grid)),
      steps_(terrain.grid->padded_size()),
      suspected_(terrain.grid->padded_size()) {
  const auto stride = static_cast<std::ptrdiff_t>(terrain.grid->stride());
  for (std::size_t d = 0; d < offsets_.size(); ++d) offsets_[d] = directions[d].y * stride + directions[d].x;
  for (std::size_t index = 0; index < blocked_.size(); ++index) {
    blocked_[index] = terrain.grid->blocked_at(index) ? 1 : 0;
    steps_[index] = blocked_[index] != 0 ? std::uint8_t{0} : moves_.legal(neighbours_[index]);
  }
  changed_.reserve(blocked_.size());
}

const std::vector<std::uint32_t>& ChangingMap::look(const OccupancyGrid& grid) {
  assert(grid.padded_size() == blocked_.size());
  changed_.clear();
  for (std::size_t first = 0; first < blocked_.size(); first += stretch) {
    const std::size_t end = std::min(first + stretch, blocked_.size());
    if (is_as_it_was(grid, first, end)) continue;
    for (std::size_t index = first; index < end; ++index) {
      if (grid.blocked_at(index) != (blocked_[index] != 0)) flip(index);
    }
  }
  const auto is_as_before = [this](std::uint32_t index) {
    suspected_[index] = 0;
    const std::uint8_t before = steps_[index];
    steps_[index] = blocked_[index] != 0 ? std::uint8_t{0} : moves_.legal(neighbours_[index]);
    return steps_[index] == before;
  };
  changed_.erase(std::remove_if(changed_.begin(), changed_.end(), is_as_before), changed_.end());
  return changed_;
}

// Without a branch inside, so that the compiler compares many cells at once.
bool ChangingMap::is_as_it_was(const OccupancyGrid& grid, std::size_t first, std::size_t end) const {
  unsigned differs = 0;
  for (std::size_t index = first; index < end; ++index) {
    differs |= static_cast<unsigned>(grid.blocked_at(index)) ^ blocked_[index];
  }
  return differs == 0;
}

void ChangingMap::flip(std::size_t index) {
  blocked_[index] ^= 1U;
  suspect(index);
  for (unsigned d = 0; d < offsets_.size(); ++d) {
    const auto beside = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(index) + offsets_[d]);
    neighbours_[beside] ^=
        static_cast<std::uint8_t>(1U << static_cast<unsigned>(opposite(static_cast<int>(d))));
    suspect(beside);
  }
}

void ChangingMap::suspect(std::size_t index) {
  if (suspected_[index] != 0) return;
  suspected_[index] = 1;
  changed_.push_back(static_cast<std::uint32_t>(index));
}

}  // namespace pathrace::baselines
