// The choice of an ant: eq. (1), ties, and its two forms.
#include "algorithms/aco/choice.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/stream.hpp"

namespace pathrace::algorithms {
namespace {

constexpr std::ptrdiff_t stride = 5;
constexpr std::size_t middle = 12;  // of a field of five by five
constexpr std::array<std::ptrdiff_t, direction_count> around = {1,  stride + 1,  stride,  stride - 1,
                                                                -1, -stride - 1, -stride, -stride + 1};

// A place to choose at: the weights of eight steps, and the marks around.
struct Place {
  TrailRow row{};
  std::array<std::uint8_t, 32> marks{};
  std::array<std::uint8_t, direction_count> recent{};

  explicit Place(const scalar::Weights& weights) {
    row.strength.fill(1);
    row.desirability = weights;
  }
  void mark(int direction) { marks[middle + static_cast<std::size_t>(around[at(direction)])] = 9; }
  static std::size_t at(int direction) { return static_cast<std::size_t>(direction); }
  ChoicePoint point(float least = 0) const {
    return {&row, marks.data() + middle, stride, 9, recent.data(), least};
  }
};

// Pearson's statistic of counts against weights.
double chi_square(const std::array<int, direction_count>& counts, const scalar::Weights& weights) {
  double total = 0;
  int draws = 0;
  for (std::size_t d = 0; d < 8; ++d) {
    total += double{weights[d]};
    draws += counts[d];
  }
  double sum = 0;
  for (std::size_t d = 0; d < 8; ++d) {
    const double expected = draws * double{weights[d]} / total;
    if (expected > 0) sum += (counts[d] - expected) * (counts[d] - expected) / expected;
  }
  return sum;
}

TEST(Choice, DrawsStepsInProportionToTheirWeights) {
  // Seven degrees of freedom: 24.32 is the 99.9 % point.
  const scalar::Weights weights = {1, 2, 3, 4, 5, 6, 7, 8};
  const Place place(weights);
  Stream stream(41);
  std::array<int, direction_count> counts{};
  for (int i = 0; i < 40000; ++i) ++counts[Place::at(choose(place.point(), stream.bits()))];
  EXPECT_LT(chi_square(counts, weights), 24.32);
}

TEST(Choice, LeavesOutMarkedAndRecentCellsAndThoseWithoutWeight) {
  Place place({1, 2, 3, 4, 0, 6, 7, 8});
  place.mark(1);
  place.mark(6);
  place.recent[7] = 255;
  const scalar::Weights left = {1, 0, 3, 4, 0, 6, 0, 0};  // three degrees of freedom: 16.27
  Stream stream(43);
  std::array<int, direction_count> counts{};
  for (int i = 0; i < 20000; ++i) ++counts[Place::at(choose(place.point(), stream.bits()))];
  for (const int d : {1, 4, 6, 7}) EXPECT_EQ(counts[Place::at(d)], 0) << d;
  EXPECT_LT(chi_square(counts, left), 16.27);
}

TEST(Choice, WeakStrengthsCountAsTheLeast) {
  Place place({1, 1, 0, 0, 0, 0, 0, 0});
  place.row.strength[0] = 1e-9F;
  place.row.strength[1] = 3;
  Stream stream(47);
  int east = 0;
  for (int i = 0; i < 20000; ++i) east += choose(place.point(1), stream.bits()) == 0 ? 1 : 0;
  EXPECT_NEAR(east, 5000, 4 * std::sqrt(20000 * 0.25 * 0.75));  // 1 : 3
}

TEST(Choice, IsNoneWhereNothingIsLeft) {
  Place place({1, 1, 1, 1, 1, 1, 1, 1});
  for (int d = 0; d < direction_count; ++d) place.mark(d);
  EXPECT_EQ(choose(place.point(), 123456789), no_choice);
  EXPECT_EQ(choose(place.point(), 123456789, 0.5F), no_choice);
  EXPECT_EQ(choose(place.point(), 0, 0.5F), no_choice);
}

TEST(Choice, OfThePseudoRandomRuleIsTheBestStepWithProbabilityQ0) {
  // The best by rule in 0.6 of the draws, and 0.3 of the others by eq. (1).
  const Place place({1, 2, 3, 1, 1, 1, 1, 0});
  Stream stream(53);
  int south = 0;
  for (int i = 0; i < 20000; ++i) south += choose(place.point(), stream.bits(), 0.6F) == 2 ? 1 : 0;
  EXPECT_NEAR(south, 20000 * (0.6 + 0.4 * 0.3), 4 * std::sqrt(20000 * 0.72 * 0.28));
}

TEST(Choice, BreaksTiesAmongTheBestWithoutACompassBias) {
  // Four equal bests, q0 = 1; three degrees of freedom.
  const scalar::Weights weights = {2, 1, 2, 0, 1, 2, 1, 2};
  const Place place(weights);
  Stream stream(59);
  std::array<int, direction_count> counts{};
  for (int i = 0; i < 20000; ++i) ++counts[Place::at(choose(place.point(), stream.bits(), 1.0F))];
  for (const int d : {1, 3, 4, 6}) EXPECT_EQ(counts[Place::at(d)], 0) << d;
  EXPECT_LT(chi_square(counts, {1, 0, 1, 0, 0, 1, 0, 1}), 16.27);
}

#ifdef __AVX2__
TEST(Choice, IsTheSameInVectorAndInScalarCode) {
  Stream stream(61);
  for (int i = 0; i < 200000; ++i) {
    Place place({});
    for (std::size_t d = 0; d < 8; ++d) {
      place.row.strength[d] = std::ldexp(stream.uniform_float(), stream.between(-60, 60));
      place.row.desirability[d] =
          stream.chance(0.2) ? 0 : std::ldexp(stream.uniform_float(), -stream.between(0, 30));
      if (stream.chance(0.2)) place.recent[d] = 255;
    }
    for (std::uint8_t& mark : place.marks) mark = stream.chance(0.3) ? 9 : 8;
    const ChoicePoint at = place.point(stream.chance(0.5) ? 0 : stream.uniform_float());
    const std::uint64_t bits = stream.chance(0.05) ? ~std::uint64_t{0} : stream.bits();
    ASSERT_EQ(vectorised::choose(at, bits), scalar::choose(at, bits)) << i;
    ASSERT_EQ(first_of(vectorised::choose_soon(at, bits)), scalar::choose(at, bits)) << i;
    ASSERT_EQ(first_of(scalar::choose_soon(at, bits)), scalar::choose(at, bits)) << i;
    ASSERT_EQ(vectorised::choose(at, bits, 0.5F), scalar::choose(at, bits, 0.5F)) << i;
  }
}
#endif

TEST(Choice, AtTheUpperEndOfTheDrawIsTheLastStepWithAWeight) {
  // 1 + 2^-30 rounds to 1: no prefix sum lies above a point that was rounded up to the total.
  const scalar::Weights weights = {1, 0x1p-30F, 0, 0, 0, 0, 0, 0};
  EXPECT_EQ(scalar::roulette(weights, 1), 1);
}

TEST(RecentSteps, CloseTheLastTwoCells) {
  for (int before = 0; before < direction_count; ++before) {
    for (int last = 0; last < direction_count; ++last) {
      RecentSteps recent;
      recent.add(before);
      recent.add(last);
      const Cell a = directions[static_cast<std::size_t>(before)];
      const Cell b = directions[static_cast<std::size_t>(last)];
      for (std::size_t d = 0; d < 8; ++d) {
        const Cell to = {a.x + b.x + directions[d].x, a.y + b.y + directions[d].y};  // from the first cell
        const bool closed = to == Cell{0, 0} || to == a;
        EXPECT_EQ(recent.closed()[d], closed ? 255 : 0) << before << ' ' << last << ' ' << d;
      }
    }
  }
}

TEST(RecentSteps, OfAWalkThatBeginsCloseNothingElse) {
  RecentSteps recent;
  for (std::size_t d = 0; d < 8; ++d) EXPECT_EQ(recent.closed()[d], 0);
  recent.add(3);
  for (std::size_t d = 0; d < 8; ++d) EXPECT_EQ(recent.closed()[d], d == 7 ? 255 : 0);
}

}  // namespace
}  // namespace pathrace::algorithms
