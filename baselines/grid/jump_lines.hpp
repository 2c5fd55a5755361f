// Where a straight run ends: at a wall, or at a jump point, a cell from which a step leads on that is not
// straight.
//
// One bit per cell, in lines along the run: rows for east and west, columns for south and north; three bits
// in all per cell and axis: wall, jump point upwards, jump point downwards. A run looks at 57 to 64 cells at
// a time: two unaligned loads of eight bytes, shifts, a count of zeros. Lines lie between eight bytes of
// wall, so that no run leaves its line.
//
// D. Harabor, A. Grastien, "Improving Jump Point Search", ICAPS 2014 (block-based scanning).
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#include "baselines/grid/canonical_moves.hpp"
#include "core/cell.hpp"
#include "core/checkpoint.hpp"
#include "core/grid.hpp"

namespace pathrace::baselines {

static_assert(std::endian::native == std::endian::little, "bit i of a line lies in byte i / 8");

/// How a run ended: after so many steps, at a jump point or in a wall.
struct Run {
  int steps;
  bool at_jump_point;
};

/// The rows of a map, or its columns. No cell is both a wall and a jump point.
class JumpLines {
 public:
  enum Layer : std::size_t { wall, jump_up, jump_down };

  /// Lines of so many cells, to be read in.
  JumpLines(int lines, int length)
      : pitch_(margin + static_cast<std::size_t>(length + 7) / 8 + margin),
        bytes_(filled_gradually<std::vector<std::uint8_t>>(static_cast<std::size_t>(lines) * 3 * pitch_, 0)) {
    for (std::size_t line = 0; line < static_cast<std::size_t>(lines); ++line) {
      checkpoint();
      std::memset(bytes_.data() + 3 * line * pitch_, 0xFF, pitch_);  // the wall layer, margins included
    }
  }

  /// Takes a line's layers from codes, one byte per cell in which bit `layer` stands for each layer. What
  /// follows the last cell must be a wall, and seven more bytes must be readable.
  void read(int line, const std::uint8_t* codes);

  bool test(Layer layer, int line, int bit) const {
    return (bytes_[offset(layer, line, bit >> 3)] >> (bit & 7) & 1) != 0;
  }
  void flip(Layer layer, int line, int bit) {
    bytes_[offset(layer, line, bit >> 3)] ^= static_cast<std::uint8_t>(1 << (bit & 7));
  }

  /// The run from `bit` towards higher bits.
  Run up(int line, int bit) const {
    for (int i = bit + 1;; i += 64 - (i & 7)) {
      const std::uint64_t walls = load(wall, line, i >> 3) >> (i & 7);
      const std::uint64_t jumps = load(jump_up, line, i >> 3) >> (i & 7);
      const std::uint64_t ends = walls | jumps;
      if (ends != 0) return {i + std::countr_zero(ends) - bit, (jumps & ends & (0 - ends)) != 0};
    }
  }
  /// The run from `bit` towards lower bits.
  Run down(int line, int bit) const {
    for (int i = bit - 1;; i -= 57 + (i & 7)) {
      const std::uint64_t walls = load(wall, line, (i >> 3) - 7) << (7 - (i & 7));
      const std::uint64_t jumps = load(jump_down, line, (i >> 3) - 7) << (7 - (i & 7));
      if ((walls | jumps) != 0) return {bit - i + std::countl_zero(walls | jumps), jumps > walls};
    }
  }

 private:
  static constexpr int margin = 8;

  std::size_t offset(Layer layer, int line, int byte) const {
    return (3 * static_cast<std::size_t>(line) + layer) * pitch_ + static_cast<std::size_t>(byte + margin);
  }
  std::uint64_t load(Layer layer, int line, int byte) const {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes_.data() + offset(layer, line, byte), sizeof word);
    return word;
  }

  std::size_t pitch_;
  std::vector<std::uint8_t> bytes_;
};

/// The lines of both axes of a map.
class JumpMap {
 public:
  JumpMap(const OccupancyGrid& grid, const CanonicalMoves& moves,
          const std::vector<std::uint8_t>& neighbours);

  /// The run from this cell in a straight direction: 0 east, 2 south, 4 west, 6 north.
  template <int direction>
  Run run(Cell from) const {
    if constexpr (direction == 0) return rows_.up(from.y, from.x);
    if constexpr (direction == 2) return columns_.up(from.x, from.y);
    if constexpr (direction == 4) return rows_.down(from.y, from.x);
    if constexpr (direction == 6) return columns_.down(from.x, from.y);
  }

  /// Makes a free cell a jump point of all directions while this lives.
  class Flag {
   public:
    Flag(JumpMap& map, Cell cell);
    Flag(const Flag&) = delete;
    Flag& operator=(const Flag&) = delete;
    ~Flag() { flip(); }

   private:
    void flip();

    JumpMap& map_;
    Cell cell_;
    std::array<bool, 4> flipped_;  // per straight direction
  };

 private:
  JumpLines rows_;
  JumpLines columns_;
};

}  // namespace pathrace::baselines
