// Deposits made while ants walk are those that would be made afterwards.
#include "algorithms/aco/early_deposits.hpp"

#include <gtest/gtest.h>

#include "tests/support/maps.hpp"

namespace pathrace::algorithms {
namespace {

using pathrace::testing::grid_of;

// Remembers for which ants it was asked, by the number of their steps.
class Recorder final : public PheromoneRule {
 public:
  explicit Recorder(const ColonySettings& settings) : PheromoneRule(settings) {}

  double initial_pheromone(const Scout& /*scout*/) const override { return 1; }
  double amount(const Walk& walk) const override {
    asked.push_back(walk.directions.size());
    return 0.3 / static_cast<double>(walk.directions.size());
  }
  Imprint imprint() const override { return left; }
  Early deposits_early() const override { return early; }
  void learn(Colony& /*colony*/, const Harvest& /*harvest*/) override {}

  Imprint left{.persistence = 0.7};
  Early early = Early::yes;
  mutable std::vector<std::size_t> asked;
};

class EarlyDepositsTest : public ::testing::Test {
 protected:
  static constexpr auto eta = [](std::size_t, int) { return 1.0; };

  // Ants of 1, 2, 3 ... steps to the east.
  EarlyDepositsTest() : walks(4) {
    trail.limit(1e-6, Trail::no_limit);
    for (std::size_t k = 0; k < walks.size(); ++k) {
      walks[k].arrived = true;
      walks[k].directions.assign(k + 1, 0);
    }
  }

  void come_back(std::size_t ant, std::uint32_t round) { roll_call.sign(ant, round); }

  // Evaporation, then deposits of the first `count` ants, as the equations have them.
  Trail after(std::size_t count) {
    Trail other(nest.moves(), 1, 1, 1, eta);
    other.limit(1e-6, Trail::no_limit);
    other.evaporate(rule.left.persistence);
    for (std::size_t k = 0; k < count; ++k) {
      if (!walks[k].arrived) continue;
      other.change_along(nest.start(), walks[k].directions, 1, 0.3 / static_cast<double>(k + 1), true);
    }
    return other;
  }

  bool equals(const Trail& other) const {
    for (std::size_t index = 0; index < nest.size(); ++index) {
      for (int d = 0; d < direction_count; ++d) {
        if (trail.pheromone(index, d) != other.pheromone(index, d)) return false;
      }
    }
    return true;
  }

  ColonySettings settings;
  Recorder rule{settings};
  OccupancyGrid grid = grid_of({"......", "......"});
  Nest nest{{grid, MoveRule::strict, {0, 0}, {5, 0}}};
  Trail trail{nest.moves(), 1, 1, 1, eta};
  std::vector<Walk> walks;
  RollCall roll_call{4, 2};
  EarlyDeposits deposits{rule, nest, trail, walks, roll_call};
};

TEST_F(EarlyDepositsTest, GoAsFarAsAntsAreBackWithoutAGap) {
  deposits.begin(4, 7);
  deposits.go_on();
  EXPECT_TRUE(rule.asked.empty());
  come_back(0, 7);
  come_back(2, 7);
  deposits.go_on();
  EXPECT_EQ(rule.asked, (std::vector<std::size_t>{1}));
  come_back(1, 7);
  deposits.go_on();
  EXPECT_EQ(rule.asked, (std::vector<std::size_t>{1, 2, 3}));
}

TEST_F(EarlyDepositsTest, KnowWhatTheirWalksComeTo) {
  walks[0].arrived = false;
  for (std::size_t k = 0; k < 4; ++k) {
    walks[k].length = length_of(walks[k].directions);
    walks[k].decisions = 10 * (k + 1);
    walks[k].pops = k;
  }
  deposits.begin(4, 3);
  for (std::size_t k = 0; k < 3; ++k) come_back(k, 3);
  deposits.go_on();
  EXPECT_EQ(deposits.tally().walks, 3U);
  EXPECT_EQ(deposits.tally().arrived, 2U);
  EXPECT_EQ(deposits.tally().decisions, 60U);
  EXPECT_EQ(deposits.tally().pops, 3U);
  EXPECT_EQ(deposits.tally().shortest, &walks[1]);
  deposits.begin(4, 4);
  EXPECT_EQ(deposits.tally().walks, 0U);
}

TEST_F(EarlyDepositsTest, AreConcludedOnceAllAreBack) {
  deposits.begin(4, 2);
  for (std::size_t k = 0; k < 4; ++k) come_back(k, 2);
  deposits.conclude();
  EXPECT_EQ(rule.asked, (std::vector<std::size_t>{1, 2, 3, 4}));
  EXPECT_EQ(deposits.tally().walks, 4U);
}

TEST_F(EarlyDepositsTest, LeaveTheTrailAloneUntilTheyAreFinished) {
  deposits.begin(4, 1);
  for (std::size_t k = 0; k < 3; ++k) come_back(k, 1);
  deposits.go_on();
  EXPECT_EQ(trail.pheromone(nest.start(), 0), 1);
  come_back(3, 1);
  EXPECT_TRUE(deposits.finish(4));
  EXPECT_TRUE(equals(after(4)));
}

TEST_F(EarlyDepositsTest, ComeInTheNextRoundToATrailThatHasAllOfTheLast) {
  for (const std::uint32_t round : {1U, 2U, 3U}) {
    const double before = trail.pheromone(nest.start(), 0);
    deposits.begin(1, round);
    deposits.go_on();
    EXPECT_EQ(rule.asked.size(), round - 1) << "an ant of the last round is not back in this one";
    come_back(0, round);
    EXPECT_TRUE(deposits.finish(1));
    EXPECT_FLOAT_EQ(static_cast<float>(trail.pheromone(nest.start(), 0)),
                    static_cast<float>(before * rule.left.persistence + 0.3));
  }
}

TEST_F(EarlyDepositsTest, OfAntsThatDoNotCountAreForgotten) {
  deposits.begin(4, 1);
  for (std::size_t k = 0; k < 4; ++k) come_back(k, 1);
  deposits.go_on();
  EXPECT_FALSE(deposits.finish(3));
  EXPECT_EQ(trail.pheromone(nest.start(), 0), 1);
  trail.evaporate(rule.left.persistence);
  for (std::size_t k = 0; k < 3; ++k) {
    trail.change_along(nest.start(), walks[k].directions, 1, 0.3 / static_cast<double>(k + 1), true);
  }
  EXPECT_TRUE(equals(after(3)));
}

TEST_F(EarlyDepositsTest, OfAntsThatDiedAreNone) {
  walks[1].arrived = false;
  deposits.begin(4, 1);
  for (std::size_t k = 0; k < 4; ++k) come_back(k, 1);
  EXPECT_TRUE(deposits.finish(4));
  EXPECT_EQ(rule.asked, (std::vector<std::size_t>{1, 3, 4}));
  EXPECT_TRUE(equals(after(4)));
}

TEST_F(EarlyDepositsTest, MayWearTheTrailOffAndCountTheDeadAndStepsTakenBack) {
  rule.left = {.persistence = 1, .factor = 0.5, .of_the_dead = true, .on_popped = true};
  walks[1].arrived = false;
  walks[2].popped = {{static_cast<std::uint32_t>(nest.start()), 2},
                     {static_cast<std::uint32_t>(grid.index({1, 1})), 7}};
  EarlyDeposits wear(rule, nest, trail, walks, roll_call);
  wear.begin(4, 1);
  for (std::size_t k = 0; k < 4; ++k) come_back(k, 1);
  ASSERT_TRUE(wear.finish(4));
  Trail other(nest.moves(), 1, 1, 1, eta);
  other.limit(1e-6, Trail::no_limit);
  for (std::size_t k = 0; k < 4; ++k) {
    const double amount = 0.3 / static_cast<double>(k + 1);
    other.change_along(nest.start(), walks[k].directions, 0.5, amount, true);
    for (const Step step : walks[k].popped) other.change(step.index, step.direction, 0.5, amount, true);
  }
  EXPECT_TRUE(equals(other));
}

TEST_F(EarlyDepositsTest, AreGivenUpAtTheFirstStepBackWhereTheRuleAsksForThat) {
  rule.early = Early::until_a_step_back;
  EarlyDeposits careful(rule, nest, trail, walks, roll_call);
  walks[2].pops = 1;
  careful.begin(4, 1);
  for (std::size_t k = 0; k < 4; ++k) come_back(k, 1);
  careful.conclude();
  EXPECT_EQ(rule.asked, (std::vector<std::size_t>{1, 2}));
  EXPECT_EQ(careful.tally().walks, 2U);
  EXPECT_FALSE(careful.finish(4));
  EXPECT_EQ(trail.pheromone(nest.start(), 0), 1);
  EXPECT_TRUE(equals(Trail(nest.moves(), 1, 1, 1, eta)));
}

// After each time that they were given up, twice as many rounds and one pass without; one success, and the
// next time counts as the first.
TEST_F(EarlyDepositsTest, PauseForLongerAndLongerWhereStepsBackGoOn) {
  rule.early = Early::until_a_step_back;
  EarlyDeposits careful(rule, nest, trail, walks, roll_call);
  std::uint32_t round = 0;
  const auto tried = [&](std::uint64_t pops) {
    walks[0].pops = pops;
    careful.begin(1, ++round);
    come_back(0, round);
    const std::size_t asked = rule.asked.size();
    careful.conclude();
    const bool made = careful.finish(1);
    EXPECT_EQ(made, rule.asked.size() > asked);
    return made;
  };
  const auto rounds_until_a_success = [&] {
    int rounds = 1;
    while (rounds < 100 && !tried(0)) ++rounds;
    return rounds;
  };
  EXPECT_FALSE(tried(1));
  EXPECT_EQ(rounds_until_a_success(), 2);
  EXPECT_FALSE(tried(1));
  for (const int pause : {1, 3, 7, 15, 31, 63, 63}) {
    for (int k = 0; k < pause; ++k) EXPECT_FALSE(tried(0)) << pause;
    EXPECT_FALSE(tried(1));
  }
  EXPECT_EQ(rounds_until_a_success(), 64);
  EXPECT_TRUE(tried(0));
}

TEST_F(EarlyDepositsTest, OthersReadTheTrailItselfDuringAPause) {
  rule.early = Early::until_a_step_back;
  EarlyDeposits careful(rule, nest, trail, walks, roll_call);
  walks[0].pops = 1;
  careful.begin(1, 1);
  EXPECT_NE(trail.rows_for_others(), trail.rows());
  come_back(0, 1);
  careful.conclude();
  EXPECT_NE(trail.rows_for_others(), trail.rows());  // somebody may just begin to walk
  careful.begin(1, 2);
  EXPECT_EQ(trail.rows_for_others(), trail.rows());
}

TEST_F(EarlyDepositsTest, AreNotBegunTwiceByOneBeginning) {
  EXPECT_FALSE(deposits.finish(0));
  deposits.begin(1, 1);
  come_back(0, 1);
  EXPECT_TRUE(deposits.finish(1));
  EXPECT_FALSE(deposits.finish(1));
}

}  // namespace
}  // namespace pathrace::algorithms
