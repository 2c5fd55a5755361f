// Exact order of a + b sqrt 2. The oracle compares s|s| with 2 d|d| in 128-bit integers; where the two sides
// are far apart, long double must agree with both.

#include "core/lattice_length.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "core/stream.hpp"
#include "tests/support/oracle.hpp"

namespace pathrace {
namespace {

int order(LatticeLength a, LatticeLength b) {
  return a < b ? -1 : a > b ? 1 : 0;
}

void expect_exact(LatticeLength a, LatticeLength b) {
  const int expected = testing::sign_of(a.straight - b.straight, a.diagonal - b.diagonal);
  ASSERT_EQ(order(a, b), expected) << a.straight << " " << a.diagonal << " | " << b.straight << " "
                                   << b.diagonal;
  ASSERT_EQ(order(b, a), -expected);
  ASSERT_EQ(a == b, expected == 0);
}

TEST(LatticeLength, ComparesExactlyOverAllSmallCounts) {
  std::vector<LatticeLength> lengths;
  for (int straight = 0; straight < 30; ++straight) {
    for (int diagonal = 0; diagonal < 30; ++diagonal) lengths.push_back({straight, diagonal});
  }
  for (const LatticeLength a : lengths) {
    for (const LatticeLength b : lengths) expect_exact(a, b);
  }
}

TEST(LatticeLength, ComparesExactlyUpToTheLargestMap) {
  Stream stream(1);
  const auto count = [&] { return static_cast<std::int64_t>(stream.below(1U << 24)); };
  for (int i = 0; i < 100000; ++i) expect_exact({count(), count()}, {count(), count()});
}

TEST(LatticeLength, AgreesWithLongDoubleWhereRoundingCannotMatter) {
  Stream stream(2);
  const auto count = [&] { return static_cast<std::int64_t>(stream.below(1000)); };
  const auto value = [](LatticeLength length) {
    return static_cast<long double>(length.straight) +
           static_cast<long double>(length.diagonal) * std::sqrt(2.0L);
  };
  for (int i = 0; i < 100000; ++i) {
    const LatticeLength a{count(), count()};
    const LatticeLength b{count(), count()};
    if (a == b) continue;
    ASSERT_EQ(a < b, value(a) < value(b))
        << a.straight << " " << a.diagonal << " | " << b.straight << " " << b.diagonal;
  }
}

// 1393^2 = 1940449 = 2 * 985^2 - 1 and 3363^2 = 11309769 = 2 * 2378^2 + 1.
TEST(LatticeLength, TellsPellNumbersFromTheirDiagonals) {
  EXPECT_LT((LatticeLength{1393, 0}), (LatticeLength{0, 985}));
  EXPECT_GT((LatticeLength{3363, 0}), (LatticeLength{0, 2378}));
}

// p^2 - 2 q^2 = -1, 1, -1, ... along (p, q) -> (p + 2q, p + q): the closest calls that there are.
TEST(LatticeLength, DecidesTheClosestCallsUpToABillionSteps) {
  std::int64_t p = 1;
  std::int64_t q = 1;
  bool below = true;
  for (; p < 1000000000; below = !below) {
    ASSERT_EQ((LatticeLength{p, 0} < LatticeLength{0, q}), below) << p << " " << q;
    ASSERT_EQ((LatticeLength{p + 5, 7} < LatticeLength{5, q + 7}), below) << p << " " << q;
    const std::int64_t next = p + 2 * q;
    q = p + q;
    p = next;
  }
}

TEST(LatticeLength, AddsByParts) {
  EXPECT_EQ((LatticeLength{1, 2} + LatticeLength{3, 4}), (LatticeLength{4, 6}));
}

TEST(LatticeLength, HasTheValueOfItsSteps) {
  EXPECT_EQ((LatticeLength{0, 0}).value(), 0.0);
  EXPECT_EQ((LatticeLength{7, 0}).value(), 7.0);
  EXPECT_NEAR((LatticeLength{3, 2}).value(), 5.82842712474619, 1e-14);
}

}  // namespace
}  // namespace pathrace
