// The choice of an ant: eight weights, a roulette, no branches.
//
// Weights of steps onto cells that carry the ant's mark count as 0; so do those onto its last two cells,
// which it need not have marked yet. That is for speed: a processor cannot read eight bytes while one of them
// is still on its way to memory, and waits some ten nanoseconds. The roulette adds the eight weights up in a
// fixed tree, draws a point below their sum and takes the first step with a weight whose prefix sum is above
// it; when round-off leaves none, the last step with a weight. The tree is that of a vector register:
// neighbours at distance one, then at distance two inside each half, then the lower half's sum onto the upper
// half. Two forms, one with AVX2 instructions and one in plain C++, give the same bits.
//
// A header, since it is the colony's inner loop.
//
// Pseudo-random proportional rule: M. Dorigo, L. M. Gambardella, "Ant Colony System", IEEE Trans. Evol. Comp.
// 1(1), 1997. Ties among the best are broken uniformly: taking the first would favour a compass direction.
#pragma once

#ifdef __AVX2__
#include <immintrin.h>
#endif

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "algorithms/aco/trail.hpp"
#include "core/moves.hpp"

namespace pathrace::algorithms {

/// What a choice depends on, besides chance.
struct ChoicePoint {
  const TrailRow* row;
  const std::uint8_t* marks;   ///< at the ant's cell in an array of the padded grid's shape
  std::ptrdiff_t stride;       ///< of that array
  std::uint8_t mark;           ///< of cells that are closed to this ant
  const std::uint8_t* recent;  ///< 255 for directions that lead to the last two cells, else 0
  float least_strength;
};

/// Uniform in [0, 1), 24 bits: from the upper bits of a draw, and from the lower ones.
inline float upper_uniform(std::uint64_t bits) {
  return static_cast<float>(static_cast<std::int32_t>(bits >> 40)) * 0x1.0p-24F;
}
inline float lower_uniform(std::uint64_t bits) {
  return static_cast<float>(static_cast<std::int32_t>(bits & 0xFFFFFFU)) * 0x1.0p-24F;
}

/// The last two steps of a walk, and the directions from its end that lead to the last two cells.
class RecentSteps {
 public:
  /// No steps yet.
  RecentSteps() = default;
  void add(int direction) { code_ = static_cast<std::uint8_t>(direction << 4 | code_ >> 4); }
  const std::uint8_t* closed() const { return table[code_].data(); }

 private:
  static constexpr unsigned none = 8;
  using Directions = std::array<std::uint8_t, direction_count>;

  static constexpr std::array<Directions, 144> make_table() {
    std::array<Directions, 144> all{};
    for (unsigned last = 0; last < none; ++last) {
      for (unsigned before = 0; before <= none; ++before) {
        Directions& closed = all[last << 4 | before];
        const Cell back = {-directions[last].x, -directions[last].y};
        closed[last ^ 4U] = 255;
        if (before == none) continue;
        const Cell further = {back.x - directions[before].x, back.y - directions[before].y};
        for (unsigned d = 0; d < none; ++d) {
          if (directions[d] == further) closed[d] = 255;
        }
      }
    }
    return all;
  }
  static const std::array<Directions, 144> table;

  std::uint8_t code_ = none << 4 | none;
};
inline constexpr std::array<RecentSteps::Directions, 144> RecentSteps::table = RecentSteps::make_table();

/// A bit beyond those of the eight directions.
inline constexpr int no_choice = 8;

/// The k-th direction, from 0, whose bit is set, k = u * number of bits. mask is not 0.
inline int uniform_choice(unsigned mask, float u) {
  auto skip = static_cast<int>(u * static_cast<float>(std::popcount(mask)));
  for (; skip > 0; --skip) mask &= mask - 1;
  return std::countr_zero(mask);
}

/// The directions that a roulette's masks leave, of which the first is its choice: those with a weight that
/// lie above the point, or the last with a weight. None when no direction has one; and no branch to tell,
/// since nobody could predict it.
inline unsigned left_by(unsigned above, unsigned weighty) {
  const unsigned candidates = above & weighty;
  const unsigned lost_to_round_off = weighty & (candidates - 1) >> 8;  // all ones >> 8 when there are none
  if (lost_to_round_off != 0) [[unlikely]]
    return std::bit_floor(weighty);
  return candidates;
}

/// The first direction of a mask, or no_choice.
inline int first_of(unsigned mask) {
  return std::countr_zero(mask | 1U << static_cast<unsigned>(no_choice));
}

namespace scalar {

using Weights = std::array<float, direction_count>;

inline Weights weights(const ChoicePoint& at) {
  const std::ptrdiff_t up = -at.stride;
  const std::ptrdiff_t down = at.stride;
  const std::array<std::ptrdiff_t, direction_count> offsets = {1,  down + 1, down, down - 1,
                                                               -1, up - 1,   up,   up + 1};
  Weights weights;
  for (std::size_t d = 0; d < direction_count; ++d) {
    const float strength = at.row->strength[d] > at.least_strength ? at.row->strength[d] : at.least_strength;
    const bool closed = at.marks[offsets[d]] == at.mark || at.recent[d] != 0;
    weights[d] = closed ? 0.0F : strength * at.row->desirability[d];
  }
  return weights;
}

inline int roulette(const Weights& weights, float u) {
  Weights sums = weights;
  for (std::size_t d = 7; d > 0; --d) {
    if (d != 4) sums[d] += sums[d - 1];
  }
  for (std::size_t d = 7; d > 1; --d) {
    if (d != 4 && d != 5) sums[d] += sums[d - 2];
  }
  for (std::size_t d = 4; d < 8; ++d) sums[d] += sums[3];
  const float point = u * sums[7];
  unsigned above = 0;
  unsigned weighty = 0;
  for (std::size_t d = 0; d < 8; ++d) {
    above |= static_cast<unsigned>(sums[d] > point) << d;
    weighty |= static_cast<unsigned>(weights[d] > 0) << d;
  }
  return first_of(left_by(above, weighty));
}

inline unsigned best(const Weights& weights) {
  float largest = 0;
  for (const float weight : weights) largest = weight > largest ? weight : largest;
  unsigned mask = 0;
  for (std::size_t d = 0; d < 8; ++d) {
    mask |= static_cast<unsigned>(weights[d] > 0 && weights[d] == largest) << d;
  }
  return mask;
}

/// Eq. (1): a direction, or no_choice when no weight is left.
inline int choose(const ChoicePoint& at, std::uint64_t bits) {
  return roulette(weights(at), upper_uniform(bits));
}

/// Directions of which the first is that of `choose`; none when no weight is left. For who can use a mask,
/// and waits for it.
inline unsigned choose_soon(const ChoicePoint& at, std::uint64_t bits) {
  const int choice = choose(at, bits);
  return choice == no_choice ? 0 : 1U << static_cast<unsigned>(choice);
}

/// The best step with probability q0, else eq. (1). The upper bits of the draw decide which.
inline int choose(const ChoicePoint& at, std::uint64_t bits, float q0) {
  const Weights w = weights(at);
  if (upper_uniform(bits) >= q0) return roulette(w, lower_uniform(bits));
  const unsigned mask = best(w);
  return mask == 0 ? no_choice : uniform_choice(mask, lower_uniform(bits));
}

}  // namespace scalar

#ifdef __AVX2__
namespace vectorised {

inline std::int32_t four_bytes(const std::uint8_t* from) {
  std::int32_t word = 0;
  std::memcpy(&word, from, sizeof word);
  return word;
}

inline __m256 weights(const ChoicePoint& at) {
  // Three bytes of the row above, of the ant's row and of the row below; reads one byte beyond them.
  __m128i bytes = _mm_cvtsi32_si128(four_bytes(at.marks - at.stride - 1));
  bytes = _mm_insert_epi32(bytes, four_bytes(at.marks - 1), 1);
  bytes = _mm_insert_epi32(bytes, four_bytes(at.marks + at.stride - 1), 2);
  const __m128i by_direction = _mm_setr_epi8(6, 10, 9, 8, 4, 0, 1, 2, -1, -1, -1, -1, -1, -1, -1, -1);
  const __m128i marks = _mm_shuffle_epi8(bytes, by_direction);
  const __m128i marked = _mm_cmpeq_epi8(marks, _mm_set1_epi8(static_cast<char>(at.mark)));
  const __m128i recent = _mm_loadl_epi64(reinterpret_cast<const __m128i*>(at.recent));
  const __m256i closed = _mm256_cvtepi8_epi32(_mm_or_si128(marked, recent));
  const __m256 strength =
      _mm256_max_ps(_mm256_load_ps(at.row->strength.data()), _mm256_set1_ps(at.least_strength));
  return _mm256_andnot_ps(_mm256_castsi256_ps(closed),
                          _mm256_mul_ps(strength, _mm256_load_ps(at.row->desirability.data())));
}

template <int bytes>
__m256 shifted(__m256 x) {
  return _mm256_castsi256_ps(_mm256_slli_si256(_mm256_castps_si256(x), bytes));
}

inline unsigned mask_of(__m256 x) {
  return static_cast<unsigned>(_mm256_movemask_ps(x));
}

inline __m256 prefix_sums(__m256 weights) {
  __m256 sums = _mm256_add_ps(weights, shifted<4>(weights));
  sums = _mm256_add_ps(sums, shifted<8>(sums));
  const __m256 low_half_above = _mm256_permute2f128_ps(sums, sums, 0x08);
  return _mm256_add_ps(sums, _mm256_shuffle_ps(low_half_above, low_half_above, 0xFF));
}

inline unsigned left_by(__m256 sums, __m256 point, __m256 weights) {
  return algorithms::left_by(mask_of(_mm256_cmp_ps(sums, point, _CMP_GT_OQ)),
                             mask_of(_mm256_cmp_ps(weights, _mm256_setzero_ps(), _CMP_GT_OQ)));
}

inline int roulette(__m256 weights, float u) {
  const __m256 sums = prefix_sums(weights);
  const __m256 total = _mm256_permutevar8x32_ps(sums, _mm256_set1_epi32(7));
  return first_of(left_by(sums, _mm256_mul_ps(_mm256_set1_ps(u), total), weights));
}

// The last of the prefix sums, everywhere. By the same additions, if of other neighbours, but without waiting
// for the others.
inline __m256 total_at_once(__m256 weights) {
  __m256 total = _mm256_add_ps(weights, _mm256_permute_ps(weights, 0xB1));
  total = _mm256_add_ps(total, _mm256_permute_ps(total, 0x4E));
  return _mm256_add_ps(total, _mm256_permute2f128_ps(total, total, 0x01));
}

inline unsigned best(__m256 weights) {
  __m256 largest = _mm256_max_ps(weights, _mm256_permute2f128_ps(weights, weights, 0x01));
  largest = _mm256_max_ps(largest, _mm256_shuffle_ps(largest, largest, 0x4E));
  largest = _mm256_max_ps(largest, _mm256_shuffle_ps(largest, largest, 0xB1));
  return mask_of(_mm256_and_ps(_mm256_cmp_ps(weights, largest, _CMP_EQ_OQ),
                               _mm256_cmp_ps(weights, _mm256_setzero_ps(), _CMP_GT_OQ)));
}

inline int choose(const ChoicePoint& at, std::uint64_t bits) {
  return roulette(weights(at), upper_uniform(bits));
}

inline unsigned choose_soon(const ChoicePoint& at, std::uint64_t bits) {
  const __m256 w = weights(at);
  const __m256 point = _mm256_mul_ps(_mm256_set1_ps(upper_uniform(bits)), total_at_once(w));
  return left_by(prefix_sums(w), point, w);
}

inline int choose(const ChoicePoint& at, std::uint64_t bits, float q0) {
  const __m256 w = weights(at);
  if (upper_uniform(bits) >= q0) return roulette(w, lower_uniform(bits));
  const unsigned mask = best(w);
  return mask == 0 ? no_choice : uniform_choice(mask, lower_uniform(bits));
}

}  // namespace vectorised
using vectorised::choose;
using vectorised::choose_soon;
#else
using scalar::choose;
using scalar::choose_soon;
#endif

}  // namespace pathrace::algorithms
