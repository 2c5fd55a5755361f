// Gaps: what they count from on each track, and what rounding may do to them.
#include "core/gap.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace pathrace {
namespace {

PathMetrics lattice(LatticeLength length) {
  PathMetrics metrics;
  metrics.lattice = length;
  metrics.length = length.value();
  return metrics;
}

PathMetrics any_angle(double length) {
  PathMetrics metrics;
  metrics.length = length;
  return metrics;
}

AnyAngleOptimum proven(double length) {
  return {true, length};
}

/// Ten straight steps on the lattice, nine cell edges at any angle.
Scenario ten_and_nine() {
  Scenario scenario;
  scenario.optimum = {true, LatticeLength{10, 0}};
  scenario.any_angle_optimum = proven(9);
  return scenario;
}

TEST(Gap, IsExactlyZeroAtTheOptimum) {
  for (std::int64_t straight = 0; straight < 40; ++straight) {
    for (std::int64_t diagonal = 0; diagonal < 40; ++diagonal) {
      const LatticeLength length{straight, diagonal};
      ASSERT_EQ(gap(lattice(length), Optimum{true, length}), 0.0);
      ASSERT_EQ(gap(any_angle(length.value()), proven(length.value())), 0.0);
    }
  }
}

TEST(Gap, IsTheShareAboveTheOptimum) {
  EXPECT_NEAR(gap(lattice({15, 0}), Optimum{true, LatticeLength{12, 0}}).value(), 0.25, 1e-15);
  EXPECT_NEAR(gap(any_angle(15), proven(12)).value(), 0.25, 1e-15);
}

TEST(Gap, OfStartAtTheGoalIsZero) {
  EXPECT_EQ(gap(lattice({0, 0}), Optimum{true, LatticeLength{0, 0}}), 0.0);
  EXPECT_EQ(gap(any_angle(0), proven(0)), 0.0);
}

TEST(Gap, IsNothingWhereThereIsNoReference) {
  EXPECT_EQ(gap(lattice({5, 0}), Optimum{}), std::nullopt);
  EXPECT_EQ(gap(lattice({5, 0}), Optimum{true, std::nullopt}), std::nullopt);
  EXPECT_EQ(gap(lattice({2, 0}), Optimum{true, LatticeLength{0, 0}}), std::nullopt);  // a share of nothing
  EXPECT_EQ(gap(any_angle(5), AnyAngleOptimum{}), std::nullopt);
  EXPECT_EQ(gap(any_angle(5), AnyAngleOptimum{true, std::nullopt}), std::nullopt);
  EXPECT_EQ(gap(any_angle(2), proven(0)), std::nullopt);
}

TEST(Gap, OfAnAnyAnglePathDoesNotDependOnTheOrderOfItsSum) {
  // A thousand legs of length sqrt 2, and the same length at once: rounded a thousand times and once.
  double sum = 0;
  for (int i = 0; i < 1000; ++i) sum += std::sqrt(2.0);
  const double whole = std::sqrt(2'000'000.0);
  ASSERT_NE(sum, whole);
  EXPECT_EQ(gap(any_angle(sum), proven(whole)), 0.0);
  EXPECT_EQ(gap(any_angle(whole), proven(sum)), 0.0);
  EXPECT_GT(gap(any_angle(whole * (1 + 1e-11)), proven(whole)), 0.0);
}

TEST(Gap, CountsFromTheReferenceOfTheTrack) {
  const Scenario scenario = ten_and_nine();
  EXPECT_EQ(reference_length(scenario, Track::lattice), 10);
  EXPECT_EQ(reference_length(scenario, Track::any_angle), 9);
  EXPECT_EQ(reference_length(scenario, Track::dynamic), std::nullopt);
  EXPECT_EQ(gap(lattice({10, 0}), scenario, Track::lattice), 0.0);
  EXPECT_EQ(gap(any_angle(9), scenario, Track::any_angle), 0.0);
  EXPECT_NEAR(gap(any_angle(9.9), scenario, Track::any_angle).value(), 0.1, 1e-15);
  EXPECT_EQ(gap(any_angle(9), scenario, Track::dynamic), std::nullopt);
  EXPECT_EQ(gap(any_angle(9), Scenario{}, Track::any_angle), std::nullopt);
  EXPECT_EQ(gap(any_angle(9), scenario.optimum), std::nullopt);  // on the lattice, no path of cells
}

TEST(Proof, IsThatOfTheTrack) {
  Scenario scenario = ten_and_nine();
  EXPECT_EQ(proof_of(scenario, Track::lattice), Proof::way);
  EXPECT_EQ(proof_of(scenario, Track::any_angle), Proof::way);
  scenario.any_angle_optimum.length.reset();
  EXPECT_EQ(proof_of(scenario, Track::any_angle), Proof::no_way);
  EXPECT_EQ(proof_of(scenario, Track::lattice), Proof::way);
  scenario.optimum = {};
  EXPECT_EQ(proof_of(scenario, Track::lattice), Proof::none);
  EXPECT_EQ(proof_of(scenario, Track::dynamic), Proof::none);
}

TEST(Contradiction, IsALegalPathBelowTheProvenOptimumOfItsTrack) {
  const Scenario scenario = ten_and_nine();
  EXPECT_EQ(contradiction(lattice({10, 0}), scenario, Track::lattice), "");
  EXPECT_EQ(contradiction(lattice({11, 0}), scenario, Track::lattice), "");
  EXPECT_EQ(contradiction(lattice({8, 1}), scenario, Track::lattice),
            "a legal path of 9.414213562373096 is shorter than the proven optimum 10");
  EXPECT_EQ(contradiction(any_angle(9.5), scenario, Track::any_angle), "");
  EXPECT_EQ(contradiction(any_angle(9 - 8e-12), scenario, Track::any_angle), "");  // within 9e-12
  EXPECT_EQ(contradiction(any_angle(8.5), scenario, Track::any_angle),
            "a legal path of 8.5 is shorter than the proven optimum 9");
  EXPECT_EQ(contradiction(any_angle(9 - 1e-11), scenario, Track::any_angle),
            "a legal path of 8.99999999999 is shorter than the proven optimum 9");
}

TEST(Contradiction, IsALegalPathWhereThereIsProvablyNoWay) {
  Scenario scenario;
  EXPECT_EQ(contradiction(lattice({1, 0}), scenario, Track::lattice), "");  // nothing is proven
  EXPECT_EQ(contradiction(any_angle(1), scenario, Track::any_angle), "");
  scenario.optimum.proven = scenario.any_angle_optimum.proven = true;
  EXPECT_NE(contradiction(lattice({1, 0}), scenario, Track::lattice).find("provably no way"),
            std::string::npos);
  EXPECT_NE(contradiction(any_angle(1), scenario, Track::any_angle).find("provably no way"),
            std::string::npos);
}

}  // namespace
}  // namespace pathrace
