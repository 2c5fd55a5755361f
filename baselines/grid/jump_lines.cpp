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
      if ((after & ~(1U << 2 * k)) != 0) {
        jumps[neighbours] = static_cast<std::uint8_t>(jumps[neighbours] | 1U << k);
      }
    }
  }
  return jumps;
}

constexpr std::uint8_t wall_code = 1U << JumpLines::wall;

// The code of a free cell, from its jump directions: those of this axis, up and down, are bits `up` and up
// + 2.
std::uint8_t code(unsigned jumps, unsigned up) {
  return static_cast<std::uint8_t>((jumps >> up & 1U) << JumpLines::jump_up | (jumps >> (up + 2) & 1U)
                                                                                  << JumpLines::jump_down);
}

std::array<std::uint8_t, 256> codes_of(const std::array<std::uint8_t, 256>& jumps, unsigned up) {
  std::array<std::uint8_t, 256> codes{};
  for (std::size_t i = 0; i < codes.size(); ++i) codes[i] = code(jumps[i], up);
  return codes;
}

}  // namespace

// Bit k of eight bytes becomes one byte: a multiplication moves them side by side into the highest one.
void JumpLines::read(int line, const std::uint8_t* codes) {
  constexpr std::uint64_t lowest_bits = 0x0101010101010101U;
  constexpr std::uint64_t side_by_side = 0x0102040810204080U;
  const int bytes = static_cast<int>(pitch_) - 2 * margin;
  for (int byte = 0; byte < bytes; ++byte) {
    std::uint64_t eight = 0;
    std::memcpy(&eight, codes + 8 * byte, sizeof eight);
    for (const Layer layer : {wall, jump_up, jump_down}) {
      const std::uint64_t gathered = (eight >> layer & lowest_bits) * side_by_side >> 56;
      bytes_[offset(layer, line, byte)] = static_cast<std::uint8_t>(gathered);
    }
  }
}

JumpMap::JumpMap(const OccupancyGrid& grid, const CanonicalMoves& moves,
                 const std::vector<std::uint8_t>& neighbours)
    : rows_(grid.height(), grid.width()), columns_(grid.width(), grid.height()) {
  const std::array<std::uint8_t, 256> jumps = jump_points(moves);
  const std::array<std::uint8_t, 256> across = codes_of(jumps, 0);
  const std::array<std::uint8_t, 256> along = codes_of(jumps, 1);
  const auto height = static_cast<std::size_t>(grid.height());
  const std::size_t length = height + 1;  // of a column with the wall below it
  std::vector<std::uint8_t> row(static_cast<std::size_t>(grid.width()) + 8, wall_code);
  auto columns = filled_gradually<std::vector<std::uint8_t>>(
      length * static_cast<std::size_t>(grid.width()) + 8, wall_code);
  for (std::size_t y = 0; y < height; ++y) {
    checkpoint();
    const std::size_t first = grid.index({0, static_cast<int>(y)});
    for (std::size_t x = 0; x < static_cast<std::size_t>(grid.width()); ++x) {
      const bool blocked = grid.blocked_at(first + x);
      row[x] = blocked ? wall_code : across[neighbours[first + x]];
      columns[x * length + y] = blocked ? wall_code : along[neighbours[first + x]];
    }
    rows_.read(static_cast<int>(y), row.data());
  }
  for (int x = 0; x < grid.width(); ++x) {
    checkpoint();
    columns_.read(x, columns.data() + static_cast<std::size_t>(x) * length);
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
