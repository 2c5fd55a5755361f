#include "algorithms/pso/row_changes.hpp"

#include <algorithm>
#include <cstring>

#include "algorithms/pso/wall_map.hpp"

namespace pathrace::algorithms {
namespace {

constexpr std::size_t lanes = RowChanges::lanes;
// Vectors of g++ and clang, for any processor. A comparison gives lanes of all bits or none.
using Ints = std::int32_t __attribute__((vector_size(lanes * sizeof(std::int32_t))));
using Places = std::uint32_t __attribute__((vector_size(lanes * sizeof(std::uint32_t))));
using Floats = float __attribute__((vector_size(lanes * sizeof(float))));

constexpr int side_bits = 10;
static_assert(ticks_per_cell == 1 << side_bits);
constexpr std::int32_t within_cell = ticks_per_cell - 1;
constexpr int cell_bits = 16;  // in the table
constexpr std::int32_t one_cell = 1 << cell_bits;

// Places are columns with 25 binary digits after the point. The way to the first one is at most 62 columns,
// rounded twice to a float, each time by 2^-24 of it, and once to a whole number. All paces together are at
// most 62 columns and 62 in number, each rounded once to a float and once to a whole number. So the last
// place errs by less than 62 (3 * 2^-24 + 2^-25) + 2^-25 < 2^-16, half of what is called near.
constexpr int digits = 25;
constexpr float unit = 0x1.0p25F;
constexpr std::uint32_t fraction = (1U << digits) - 1;
constexpr std::uint32_t near = 1U << (digits - 15);

// The segments from left to right, in rows that are columns of the map where it is steep.
struct Runs {
  Ints steep;
  Ints left;
  Ints right;
  Ints begin;  // height at the left end
  Ints end;    // height at the right end
  Ints up;     // to smaller heights
  Ints run;    // width, at least the rise
  Ints rise;   // height, without sign
};

inline void orient(const RowChanges::Points& from, const RowChanges::Points& to, Runs& runs) {
  Ints x;
  Ints y;
  Ints dx;
  Ints dy;
  std::memcpy(&x, from.x.data(), sizeof x);
  std::memcpy(&y, from.y.data(), sizeof y);
  std::memcpy(&dx, to.x.data(), sizeof dx);
  std::memcpy(&dy, to.y.data(), sizeof dy);
  dx -= x;
  dy -= y;
  const Ints width = dx < 0 ? -dx : dx;
  const Ints height = dy < 0 ? -dy : dy;
  runs.steep = height > width;
  runs.run = runs.steep ? height : width;
  runs.rise = runs.steep ? width : height;
  const Ints along = runs.steep ? dy : dx;
  const Ints across = runs.steep ? dx : dy;
  const Ints back = along < 0;
  runs.left = (runs.steep ? y : x) + (back & along);
  runs.begin = (runs.steep ? x : y) + (back & across);
  const Ints climb = back ? -across : across;
  runs.up = climb < 0;
  runs.right = runs.left + runs.run;
  runs.end = runs.begin + climb;
}

// No length, or an end on a line.
inline void doubt(const Runs& runs, Ints& unsure) {
  unsure = (runs.run == 0) | ((runs.left & within_cell) == 0) | ((runs.right & within_cell) == 0) |
           ((runs.begin & within_cell) == 0) | ((runs.end & within_cell) == 0);
}

// The changes of rows of each lane that are still to come.
struct Walks {
  Ints left;     // how many
  Places place;  // of the next one
  Places pace;   // from one to the next
  Ints entry;    // in the table, of the next one, but for its column
  Ints stride;   // from one to the next
};

// Within one row there is no change, but its place stays inside the map all the same. A pace of 64 columns or
// more is not taken: there is no second change then.
inline void set_out(const Runs& runs, Walks& walks) {
  const Ints rows = (runs.end >> side_bits) - (runs.begin >> side_bits);
  walks.left = runs.up ? -rows : rows;
  const Ints to_line = (runs.up ? runs.begin : -runs.begin) & within_cell;
  const Ints fall = to_line < runs.rise ? to_line : runs.rise;
  const Ints divisor = runs.rise == 0 ? Ints{} + 1 : runs.rise;
  const Floats ratio = __builtin_convertvector(runs.run, Floats) / __builtin_convertvector(divisor, Floats);
  const Floats ahead = ratio * __builtin_convertvector(fall, Floats) * (unit / ticks_per_cell);
  const Floats pace = (ratio < 64 ? ratio : Floats{}) * unit;
  const Ints from_left = __builtin_convertvector(ahead, Ints);
  const Ints whole_pace = __builtin_convertvector(pace, Ints);
  const Ints left_end = runs.left << (digits - side_bits);
  walks.place = __builtin_convertvector(left_end + from_left, Places);
  walks.pace = __builtin_convertvector(whole_pace, Places);
}

// Entries of the table, lane by lane.
inline void look_up(const std::int32_t* table, const Ints& at, Ints& found) {
  for (std::size_t k = 0; k < lanes; ++k) found[k] = table[at[k]];
}

// Adds what the changes of rows bring, and marks the lanes that have one too close to a line.
inline void follow(const std::int32_t* table, Walks& walks, Ints& met, Ints& unsure) {
  std::int32_t most = 0;
  for (std::size_t k = 0; k < lanes; ++k) most = std::max(most, walks.left[k]);
  walks.place += near;
  Ints found{};
  for (; most > 0; --most) {
    const Ints on = walks.left > 0;
    const Ints column = __builtin_convertvector(walks.place >> digits, Ints);
    look_up(table, on & (walks.entry + column), found);
    met += found;
    unsure |= on & ((walks.place & fraction) < 2 * near);
    walks.left -= 1;
    walks.place += walks.pace;
    walks.entry += walks.stride;
  }
}

inline void add(const Ints& lanes_of_sum, std::array<std::uint32_t, lanes>& sums) {
  Places sum;
  std::memcpy(&sum, sums.data(), sizeof sum);
  sum += __builtin_convertvector(lanes_of_sum, Places);
  std::memcpy(sums.data(), &sum, sizeof sum);
}

// Bit k for lane k; most often none.
inline std::uint32_t lanes_of(const Ints& mask) {
  std::array<std::uint64_t, sizeof(Ints) / sizeof(std::uint64_t)> words;
  std::memcpy(words.data(), &mask, sizeof mask);
  std::uint64_t any = 0;
  for (const std::uint64_t word : words) any |= word;
  std::uint32_t bits = 0;
  if (any == 0) return bits;
  for (std::size_t k = 0; k < lanes; ++k) bits |= static_cast<std::uint32_t>(mask[k] & 1) << k;
  return bits;
}

}  // namespace

RowChanges::RowChanges(const OccupancyGrid& grid)
    : side_(std::max(grid.width(), grid.height()) + 3),
      size_(side_ * side_),
      table_(static_cast<std::size_t>(1 + 6 * size_), 0) {
  fill(grid, false);
  fill(grid, true);
}

void RowChanges::fill(const OccupancyGrid& grid, bool transposed) {
  std::int32_t* const down = table_.data() + 1 + (transposed ? 2 * size_ : 0);
  std::int32_t* const up = down + size_;
  std::int32_t* const before = table_.data() + 1 + (transposed ? 5 : 4) * size_;
  for (std::int32_t r = 0; r < side_; ++r) {
    for (std::int32_t c = 0; c + 1 < side_; ++c) {
      const bool free = grid.is_free(transposed ? Cell{r - 1, c - 1} : Cell{c - 1, r - 1});
      before[r * side_ + c + 1] = before[r * side_ + c] + one_cell + (free ? 0 : 1);
    }
  }
  for (std::int32_t upper = 0; upper + side_ + 1 < size_; ++upper) {
    const std::int32_t lower = upper + side_;
    down[upper] = before[upper + 1] - before[lower];
    up[lower] = before[lower + 1] - before[upper];
  }
}

std::uint32_t RowChanges::cross(const Points& from, const Points& to, Sums& sums) const {
  Runs runs;
  orient(from, to, runs);
  Ints unsure;
  doubt(runs, unsure);
  Walks walks;
  set_out(runs, walks);
  const Ints plane = (runs.steep & size_) + 1;
  const Ints begin = (runs.begin >> side_bits) * side_;
  const Ints end = (runs.end >> side_bits) * side_;
  walks.entry = begin + plane + (runs.steep & size_) + (runs.up & size_);
  walks.stride = runs.up ? Ints{} - side_ : Ints{} + side_;
  const Ints before = plane + 4 * size_;
  Ints met{};
  Ints found{};
  look_up(table_.data(), before + end + (runs.right >> side_bits) + 1, met);
  look_up(table_.data(), before + begin + (runs.left >> side_bits), found);
  met -= found;
  follow(table_.data(), walks, met, unsure);
  met &= ~unsure;
  add(met & (one_cell - 1), sums.walls);
  add(met >> cell_bits, sums.cells);
  return lanes_of(unsure);
}

}  // namespace pathrace::algorithms
