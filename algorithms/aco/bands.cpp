#include "algorithms/aco/bands.hpp"

#ifdef __AVX2__
#include <immintrin.h>
#endif

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include "core/moves.hpp"

namespace pathrace::algorithms {
namespace {

using Steps = std::span<const std::uint8_t>;

constexpr std::ptrdiff_t unlimited = std::ptrdiff_t{1} << 40;  // beyond the rim of the map there is no band

// Where a path is, and how many rows it may go up or down without leaving its band.
struct Place {
  std::ptrdiff_t index;
  std::ptrdiff_t up;
  std::ptrdiff_t down;

  bool is_in_band() const { return up >= 0 && down >= 0; }
};

#ifdef __AVX2__
constexpr std::size_t many = 16;  // steps in a vector

// Rows down after each of these steps.
__m128i rows_down(__m128i steps) {
  __m128i rows = _mm_shuffle_epi8(_mm_setr_epi8(0, 1, 1, 1, 0, -1, -1, -1, 0, 0, 0, 0, 0, 0, 0, 0), steps);
  rows = _mm_add_epi8(rows, _mm_slli_si128(rows, 1));
  rows = _mm_add_epi8(rows, _mm_slli_si128(rows, 2));
  rows = _mm_add_epi8(rows, _mm_slli_si128(rows, 4));
  return _mm_add_epi8(rows, _mm_slli_si128(rows, 8));
}

__m128i at_most_many(std::ptrdiff_t rows) {
  return _mm_set1_epi8(static_cast<char>(std::min<std::ptrdiff_t>(rows, many)));
}

// How many of the first `count` steps come before the place is in another band.
std::size_t steps_within(const Place& place, __m128i steps, std::size_t count) {
  const __m128i rows = rows_down(steps);
  const __m128i below = _mm_cmpgt_epi8(rows, at_most_many(place.down));
  const __m128i above = _mm_cmpgt_epi8(_mm_sub_epi8(_mm_setzero_si128(), rows), at_most_many(place.up));
  const auto outside = static_cast<unsigned>(_mm_movemask_epi8(_mm_or_si128(below, above)));
  return std::min(count, static_cast<std::size_t>(std::countr_zero(outside)) + 1);
}

// The steps, added up: columns to the right + count, and 64 times (rows down + count).
std::ptrdiff_t sum_of(__m128i steps, std::size_t count) {
  __m128i moves = _mm_shuffle_epi8(
      _mm_setr_epi8(64 + 2, -128 + 2, -128 + 1, -128, 64, 0, 1, 2, 0, 0, 0, 0, 0, 0, 0, 0), steps);
  if (count < many) {
    const __m128i number = _mm_setr_epi8(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
    moves = _mm_and_si128(moves, _mm_cmpgt_epi8(_mm_set1_epi8(static_cast<char>(count)), number));
  }
  const __m128i halves = _mm_sad_epu8(moves, _mm_setzero_si128());
  return std::ptrdiff_t{_mm_cvtsi128_si32(halves)} + _mm_extract_epi16(halves, 4);
}

__m128i first_of(Steps steps) {
  std::array<std::uint8_t, many> bytes{};
  std::memcpy(bytes.data(), steps.data(), steps.size());
  return _mm_loadu_si128(reinterpret_cast<const __m128i*>(bytes.data()));
}

// Goes along a path, a number of steps, but none beyond the first that leads to another band. How many?
std::size_t go(Place& place, Steps path, std::ptrdiff_t stride) {
  const bool are_many = path.size() >= many;
  const __m128i steps =
      are_many ? _mm_loadu_si128(reinterpret_cast<const __m128i*>(path.data())) : first_of(path);
  std::size_t count = are_many ? many : path.size();
  const bool may_leave = std::min(place.up, place.down) < static_cast<std::ptrdiff_t>(many);
  if (may_leave) count = steps_within(place, steps, count);
  const std::ptrdiff_t sum = sum_of(steps, count);
  const auto gone = static_cast<std::ptrdiff_t>(count);
  const std::ptrdiff_t down = (sum >> 6) - gone;
  place = {place.index + down * stride + (sum & 63) - gone, place.up + down, place.down - down};
  return count;
}
#else
std::size_t go(Place& place, Steps path, std::ptrdiff_t stride) {
  const auto [right, down] = directions[path[0]];
  place = {place.index + down * stride + right, place.up + down, place.down - down};
  return 1;
}
#endif

}  // namespace

Bands::Bands(std::size_t cells, std::size_t stride, std::size_t count)
    : cells_(cells),
      stride_(static_cast<std::ptrdiff_t>(stride)),
      rows_(static_cast<std::ptrdiff_t>((cells / stride + count - 1) / count)),
      last_(static_cast<std::ptrdiff_t>(cells / stride - 1) / rows_) {}

CellRange Bands::operator[](std::size_t band) const {
  const auto cells = static_cast<std::size_t>(rows_ * stride_);
  return {std::min(cells_, band * cells), std::min(cells_, (band + 1) * cells)};
}

void Bands::split(std::size_t start, Steps path, std::vector<Stretch>& stretches) const {
  stretches.clear();
  Place place{static_cast<std::ptrdiff_t>(start), 0, 0};
  std::ptrdiff_t band = place.index / stride_ / rows_;
  std::ptrdiff_t row = place.index / stride_ % rows_;  // of the band
  for (std::size_t k = 0;;) {
    place.up = band == 0 ? unlimited : row;
    place.down = band == last_ ? unlimited : rows_ - 1 - row;
    stretches.push_back({static_cast<std::uint32_t>(k), static_cast<std::uint32_t>(place.index)});
    while (k < path.size() && place.is_in_band()) k += go(place, path.subspan(k), stride_);
    if (place.is_in_band()) return;
    const bool above = place.up < 0;
    row = above ? rows_ - 1 : 0;
    band += above ? -1 : 1;
  }
}

}  // namespace pathrace::algorithms
