#include "core/moves.hpp"

#include "core/checkpoint.hpp"

namespace pathrace {
namespace {

// Which of the eight steps are legal, given which of the eight neighbours are free. One entry per
// pattern of free neighbours, so that building a table costs one look-up per cell.
std::array<std::uint8_t, 256> legal_by_pattern(MoveRule rule) {
  std::array<std::uint8_t, 256> legal{};
  for (unsigned pattern = 0; pattern < 256; ++pattern) {
    const auto is_free = [&](int direction) { return (pattern >> (direction & 7) & 1U) != 0; };
    unsigned mask = 0;
    for (int d = 0; d < direction_count; ++d) {
      if (!is_free(d)) continue;
      bool allowed = true;
      if (is_diagonal(d)) {
        const bool before = is_free(d - 1);
        const bool after = is_free(d + 1);
        switch (rule) {
          case MoveRule::four: allowed = false; break;
          case MoveRule::strict: allowed = before && after; break;
          case MoveRule::squeeze: allowed = before || after; break;
          case MoveRule::free: break;
        }
      }
      if (allowed) mask |= 1U << d;
    }
    legal[pattern] = static_cast<std::uint8_t>(mask);
  }
  return legal;
}

}  // namespace

MoveTable::MoveTable(const OccupancyGrid& grid, MoveRule rule)
    : masks_(filled_gradually<std::vector<std::uint8_t>>(grid.padded_size(), 0)) {
  const auto stride = static_cast<std::ptrdiff_t>(grid.stride());
  for (std::size_t d = 0; d < direction_count; ++d) {
    offsets_[d] = directions[d].y * stride + directions[d].x;
  }
  const auto legal = legal_by_pattern(rule);
  for (int y = 0; y < grid.height(); ++y) {
    checkpoint();
    const std::size_t row = grid.index({0, y});
    for (std::size_t index = row; index < row + static_cast<std::size_t>(grid.width()); ++index) {
      if (grid.blocked_at(index)) continue;
      unsigned pattern = 0;
      for (int d = 0; d < direction_count; ++d) {
        pattern |= static_cast<unsigned>(!grid.blocked_at(step(index, d))) << d;
      }
      masks_[index] = legal[pattern];
    }
  }
}

}  // namespace pathrace
