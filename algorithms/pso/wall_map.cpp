#include "algorithms/pso/wall_map.hpp"

#include <algorithm>
#include <bit>
#include <cstdlib>

#include "core/checkpoint.hpp"

namespace pathrace::algorithms {
namespace {

constexpr std::int32_t side = ticks_per_cell;
constexpr int side_bits = 10;
static_assert(side == 1 << side_bits);

bool on_line(std::int32_t tick) {
  return (tick & (side - 1)) == 0;
}

// The columns first..last of a row.
struct Span {
  std::int64_t first;
  std::int64_t last;
};

// Row by row downwards. In a row the segment reaches from where it crosses the row's upper line, or begins,
// to where it crosses the lower one, or ends: from place a to place b > a, it enters the columns from
// floor(a) to ceil(b) - 1. Of each place a walk keeps the floor and the ceiling less one; they differ only on
// a line between columns.
class Descent {
 public:
  explicit Descent(Tick upper, Tick lower)
      : rightwards_(lower.x > upper.x), low_(upper.x >> side_bits), high_((upper.x - 1) >> side_bits) {}

  /// Goes on to the next place; the columns entered on the way.
  Span to(std::int64_t low, std::int64_t high) {
    const Span span{rightwards_ ? low_ : low, rightwards_ ? high : high_};
    low_ = low;
    high_ = high;
    return span;
  }

 private:
  bool rightwards_;
  std::int64_t low_;
  std::int64_t high_;
};

}  // namespace

WallMap::WallMap(const OccupancyGrid& grid) : rows_(grid, false), columns_(grid, true) {
  if (RowChanges::cover(grid)) changes_.emplace(grid);
}

void WallMap::cross(const RowChanges::Points& from, const RowChanges::Points& to, std::size_t count,
                    RowChanges::Sums& sums) const {
  const std::uint32_t asked = (1U << count) - 1;
  std::uint32_t left = asked & (changes_ ? changes_->cross(from, to, sums) : asked);
  for (; left != 0; left &= left - 1) {
    const auto k = static_cast<std::size_t>(std::countr_zero(left));
    const Crossing crossing = cross({from.x[k], from.y[k]}, {to.x[k], to.y[k]});
    sums.walls[k] += crossing.walls;
    sums.cells[k] += crossing.cells;
  }
}

Crossing WallMap::cross(Tick from, Tick to) const {
  const std::int32_t dx = std::abs(to.x - from.x);
  const std::int32_t dy = std::abs(to.y - from.y);
  if (dx == 0 || dy == 0) return cross_level(from, to);
  const bool steep = dy > dx;
  const Rows& rows = steep ? columns_ : rows_;
  const Tick a = steep ? Tick{from.y, from.x} : from;
  const Tick b = steep ? Tick{to.y, to.x} : to;
  const bool down = a.y < b.y;
  const Tick upper{down ? a.x : b.x, down ? a.y : b.y};
  const Tick lower{down ? b.x : a.x, down ? b.y : a.y};
  return rows.slope(upper, lower);
}

Crossing WallMap::cross_level(Tick from, Tick to) const {
  if (from == to) return {};
  if (from.y == to.y) return rows_.level(std::min(from.x, to.x), std::max(from.x, to.x), from.y);
  return columns_.level(std::min(from.y, to.y), std::max(from.y, to.y), from.x);
}

WallMap::Rows::Rows(const OccupancyGrid& grid, bool transposed)
    : width_((transposed ? grid.height() : grid.width()) + 2),
      height_((transposed ? grid.width() : grid.height()) + 2),
      words_((width_ + 63) / 64),
      blocked_(static_cast<std::size_t>(words_ * height_), 0),
      seams_(blocked_),
      corners_(blocked_) {
  const auto blocked = [&](std::int64_t row, std::int64_t column) {
    const auto x = static_cast<int>(column) - 1;
    const auto y = static_cast<int>(row) - 1;
    return !grid.is_free(transposed ? Cell{y, x} : Cell{x, y});
  };
  for (std::int64_t r = 0; r < height_; ++r) {
    checkpoint();
    for (std::int64_t c = 0; c < width_; ++c) {
      if (blocked(r, c)) set(blocked_, r, c);
      if (r == 0 || c == 0) continue;
      const bool up = blocked(r - 1, c);
      const bool left = blocked(r, c - 1);
      if (up && blocked(r, c)) set(seams_, r, c);
      if (up == left && blocked(r, c) == blocked(r - 1, c - 1) && up != blocked(r, c)) set(corners_, r, c);
    }
  }
}

void WallMap::Rows::set(Bits& bits, std::int64_t row, std::int64_t column) const {
  bits[static_cast<std::size_t>(row * words_ + column / 64)] |= std::uint64_t{1} << (column % 64);
}

std::uint32_t WallMap::Rows::bit(const Bits& bits, std::int64_t row, std::int64_t column) const {
  return bits[static_cast<std::size_t>(row * words_ + column / 64)] >> (column % 64) & 1;
}

// Set bits in columns first..last of a row; none when last < first.
std::uint32_t WallMap::Rows::count(const Bits& bits, std::int64_t row, std::int64_t first,
                                   std::int64_t last) const {
  if (last < first) return 0;
  const std::uint64_t* const words = bits.data() + row * words_;
  const std::int64_t begin = first / 64;
  const std::int64_t end = last / 64;
  const std::uint64_t head = ~std::uint64_t{0} << (first % 64);
  const std::uint64_t tail = ~std::uint64_t{0} >> (63 - last % 64);
  if (begin == end) return static_cast<std::uint32_t>(std::popcount(words[begin] & head & tail));
  int sum = std::popcount(words[begin] & head) + std::popcount(words[end] & tail);
  for (std::int64_t k = begin + 1; k < end; ++k) sum += std::popcount(words[k]);
  return static_cast<std::uint32_t>(sum);
}

std::uint32_t WallMap::Rows::corner(Tick tick) const {
  if (!on_line(tick.x) || !on_line(tick.y)) return 0;
  return bit(corners_, tick.y >> side_bits, tick.x >> side_bits);
}

// Along a row, or along the line between two rows.
Crossing WallMap::Rows::level(std::int32_t low, std::int32_t high, std::int32_t y) const {
  const std::int32_t first = low >> side_bits;
  const std::int32_t last = (high - 1) >> side_bits;
  const std::int32_t row = y >> side_bits;
  const auto cells = static_cast<std::uint32_t>(last - first + 1);
  if (!on_line(y)) return {count(blocked_, row, first, last), cells};
  const std::int32_t first_corner = (low + side - 1) >> side_bits;
  const std::int32_t last_corner = high >> side_bits;
  return {count(seams_, row, first, last) + count(corners_, row, first_corner, last_corner), 2 * cells};
}

Crossing WallMap::Rows::slope(Tick upper, Tick lower) const {
  return words_ == 1 ? slope_narrow(upper, lower) : slope_wide(upper, lower);
}

// Maps up to 62 cells wide: a row is one word, and places are whole numbers with 40 binary digits after the
// point. Their errors stay below 2^-33, and a place that is on no line is more than 2^-26 from one.
Crossing WallMap::Rows::slope_narrow(Tick upper, Tick lower) const {
  constexpr int digits = 40;
  constexpr std::int64_t near = std::int64_t{1} << (digits - 30);
  const std::int64_t top = upper.y >> side_bits;
  const std::int64_t bottom = (lower.y - 1) >> side_bits;
  const double ratio = static_cast<double>(lower.x - upper.x) / static_cast<double>(lower.y - upper.y);
  const auto slope = static_cast<std::int64_t>(ratio * 0x1.0p40);
  // Within one row no line is crossed and the place is not used: it must not overflow there.
  const std::int64_t to_line = std::min<std::int64_t>((top + 1) * side, lower.y) - upper.y;
  std::int64_t place = (std::int64_t{upper.x} << (digits - side_bits)) + ((slope * to_line) >> side_bits);

  Crossing crossing{corner(upper) + corner(lower), 0};
  const std::uint64_t* words = blocked_.data() + top;
  const auto enter = [&](Span span) {
    const std::uint64_t columns = ((std::uint64_t{2} << (span.last - span.first)) - 1) << span.first;
    crossing.walls += static_cast<std::uint32_t>(std::popcount(*words++ & columns));
    crossing.cells += static_cast<std::uint32_t>(span.last - span.first + 1);
  };
  Descent descent(upper, lower);
  for (std::int64_t line = top + 1; line <= bottom; ++line, place += slope) {
    const std::int64_t low = (place + near) >> digits;
    const std::int64_t high = (place - near) >> digits;
    if (low != high) crossing.walls += bit(corners_, line, low);
    enter(descent.to(low, high));
  }
  enter(descent.to(lower.x >> side_bits, (lower.x - 1) >> side_bits));
  return crossing;
}

// Any width, places as quotients: a whole number times a rounded inverse errs by less than 2^-37 (quotients
// are below 2^14.1), and a place that is on no line is more than 2^-35 from one (denominators are below
// 2^34.1).
Crossing WallMap::Rows::slope_wide(Tick upper, Tick lower) const {
  constexpr double near = 0x1.0p-36;
  const std::int64_t top = upper.y >> side_bits;
  const std::int64_t bottom = (lower.y - 1) >> side_bits;
  const auto dx = static_cast<double>(lower.x - upper.x);
  const auto dy = static_cast<double>(lower.y - upper.y);
  const double inverse = 1 / (dy * side);
  const double base = static_cast<double>(upper.x) * dy - dx * static_cast<double>(upper.y);

  Crossing crossing{corner(upper) + corner(lower), 0};
  const auto enter = [&](std::int64_t row, Span span) {
    crossing.walls += count(blocked_, row, span.first, span.last);
    crossing.cells += static_cast<std::uint32_t>(span.last - span.first + 1);
  };
  Descent descent(upper, lower);
  for (std::int64_t line = top + 1; line <= bottom; ++line) {
    const double place = (base + dx * side * static_cast<double>(line)) * inverse;
    const auto low = static_cast<std::int64_t>(place + near);
    const auto high = static_cast<std::int64_t>(place - near);
    if (low != high) crossing.walls += bit(corners_, line, low);
    enter(line - 1, descent.to(low, high));
  }
  enter(bottom, descent.to(lower.x >> side_bits, (lower.x - 1) >> side_bits));
  return crossing;
}

}  // namespace pathrace::algorithms
