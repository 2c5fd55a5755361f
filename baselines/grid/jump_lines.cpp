#include "baselines/grid/jump_lines.hpp"

namespace pathrace::baselines {
namespace {

// For each pattern of free neighbours, the straight directions (bit k for direction 2 k) of arrival from
// which another step than the straight one leads on.
std::array<std::uint8_t, 256> jump_points(const CanonicalMoves& moves) {
  std::array<std::uint8_t, 256> jumps{};
  for (unsigned neighbours = 0; neighbours < 256; ++neighbours) {
    for (unsigned k = 0; k < 4; ++k) {
      const unsigned after = moves.after(2 * k, static_cast<std::uint8_t>(neighbours));
      if ((after & ~(1U << 2 * k)) != 0)
        jumps[neighbours] = static_cast<std::uint8_t>(jumps[neighbours] | 1U << k);
    }
  }
  return jumps;
}

}  // namespace

JumpMap::JumpMap(const OccupancyGrid& grid, const CanonicalMoves& moves,
                 const std::vector<std::uint8_t>& neighbours)
    : rows_(grid.height(), grid.width()), columns_(grid.width(), grid.height()) {
  const std::array<std::uint8_t, 256> jumps = jump_points(moves);
  for (int y = 0; y < grid.height(); ++y) {
    const std::size_t row = grid.index({0, y});
    for (int x = 0; x < grid.width(); ++x) {
      const std::size_t index = row + static_cast<std::size_t>(x);
      if (grid.blocked_at(index)) continue;
      rows_.flip(JumpLines::wall, y, x);
      columns_.flip(JumpLines::wall, x, y);
      const unsigned here = jumps[neighbours[index]];
      if (here == 0) continue;
      if ((here & 1U) != 0) rows_.flip(JumpLines::jump_up, y, x);
      if ((here & 2U) != 0) columns_.flip(JumpLines::jump_up, x, y);
      if ((here & 4U) != 0) rows_.flip(JumpLines::jump_down, y, x);
      if ((here & 8U) != 0) columns_.flip(JumpLines::jump_down, x, y);
    }
  }
}

JumpMap::Flag::Flag(JumpMap& map, Cell cell)
    : map_(map),
      cell_(cell),
      flipped_{!map.rows_.test(JumpLines::jump_up, cell.y, cell.x),
               !map.columns_.test(JumpLines::jump_up, cell.x, cell.y),
               !map.rows_.test(JumpLines::jump_down, cell.y, cell.x),
               !map.columns_.test(JumpLines::jump_down, cell.x, cell.y)} {
  flip();
}

void JumpMap::Flag::flip() {
  if (flipped_[0]) map_.rows_.flip(JumpLines::jump_up, cell_.y, cell_.x);
  if (flipped_[1]) map_.columns_.flip(JumpLines::jump_up, cell_.x, cell_.y);
  if (flipped_[2]) map_.rows_.flip(JumpLines::jump_down, cell_.y, cell_.x);
  if (flipped_[3]) map_.columns_.flip(JumpLines::jump_down, cell_.x, cell_.y);
}

}  // namespace pathrace::baselines
