// The trail, against equations (1) to (3), and its lazy form against a reference that sweeps the map.
#include "algorithms/aco/trail.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "algorithms/aco/power.hpp"
#include "core/stream.hpp"
#include "tests/algorithms/trail_field.hpp"

namespace pathrace::algorithms {
namespace {

// tau in doubles, every step in every iteration, as the equations are written.
class SweptTrail {
 public:
  SweptTrail(std::size_t cells, double initial) : tau_(cells * direction_count, initial) {}

  double& at(std::size_t index, int direction) {
    return tau_[index * direction_count + static_cast<std::size_t>(direction)];
  }
  void evaporate(double persistence) {
    for (double& tau : tau_) tau = within(tau * persistence);
  }
  void change(std::size_t index, int direction, double factor, double amount) {
    at(index, direction) = within(at(index, direction) * factor + amount);
  }
  void limit(double lower, double upper) {
    lower_ = lower;
    upper_ = upper;
    for (double& tau : tau_) tau = within(tau);
  }

 private:
  double within(double tau) const { return std::min(std::max(tau, lower_), upper_); }

  std::vector<double> tau_;
  double lower_ = 0;
  double upper_ = Trail::no_limit;
};

TEST(Power, MultipliesIntegerExponentsOut) {
  EXPECT_EQ(power(3, 0), 1);
  EXPECT_EQ(power(3, 1), 3);
  EXPECT_EQ(power(3, 7), 2187);
  EXPECT_EQ(power(0.5, 10), 1.0 / 1024);
  EXPECT_DOUBLE_EQ(power(2, 0.5), std::sqrt(2.0));
}

TEST(Trail, WeightsAreEquationOneUpToTheRowsFactor) {
  // eta = 4 to the east, 2 elsewhere, beta = 2, tau = 1: east weighs 16 / 4 = 4 times as much as any other
  // step.
  Field field(open_ground, MoveRule::free, 1, 2, [](std::size_t, int d) { return d == 0 ? 4.0 : 2.0; });
  const std::size_t middle = field.at(1, 1);
  for (int d = 1; d < direction_count; ++d) {
    EXPECT_FLOAT_EQ(field.trail.weight(middle, 0) / field.trail.weight(middle, d), 4);
  }
}

TEST(Trail, AlphaIsTheExponentOfThePheromone) {
  for (const double alpha : {0.0, 0.5, 1.0, 2.0, 3.0}) {
    Field field(open_ground, MoveRule::free, alpha, 1, equal);
    const std::size_t middle = field.at(1, 1);
    field.trail.evaporate(0.5);
    field.trail.deposit(middle, 3, 4, false);  // 4.5 against 0.5
    EXPECT_NEAR(field.trail.weight(middle, 3) / field.trail.weight(middle, 0), std::pow(9, alpha), 1e-4);
  }
}

TEST(Trail, EvaporatesAndDepositsByEquationsTwoAndThree) {
  Field field(open_ground, MoveRule::free, 1, 1, equal);
  const std::size_t middle = field.at(1, 1);
  const std::size_t east = field.at(2, 1);
  field.trail.evaporate(0.75);
  field.trail.deposit(middle, 0, 0.5, true);
  EXPECT_FLOAT_EQ(static_cast<float>(field.trail.pheromone(middle, 0)), 0.75F + 0.5F);
  EXPECT_FLOAT_EQ(static_cast<float>(field.trail.pheromone(east, 4)), 0.75F + 0.5F);
  EXPECT_FLOAT_EQ(static_cast<float>(field.trail.pheromone(middle, 2)), 0.75F);
  field.trail.deposit(middle, 2, 0.5, false);
  EXPECT_FLOAT_EQ(static_cast<float>(field.trail.pheromone(field.at(1, 2), 6)), 0.75F);
}

TEST(Trail, DoesNotFallBelowItsFloor) {
  Field field({".."}, MoveRule::four, 1, 1, equal);
  field.trail.limit(1e-3, Trail::no_limit);
  for (int i = 0; i < 200; ++i) field.trail.evaporate(0.5);
  EXPECT_FLOAT_EQ(static_cast<float>(field.trail.pheromone(field.at(0, 0), 0)), 1e-3F);
}

TEST(Trail, LosesEverythingWhenNothingPersists) {
  Field field({".."}, MoveRule::four, 1, 1, equal);
  field.trail.evaporate(0);
  EXPECT_EQ(field.trail.pheromone(field.at(0, 0), 0), 0);
  field.trail.deposit(field.at(0, 0), 0, 3, false);
  EXPECT_EQ(field.trail.pheromone(field.at(0, 0), 0), 3);
}

TEST(Trail, LargeExponentsOnLargeMapsKeepTheOrderOfTheSteps) {
  // 1 / distance to the power 40, 700 cells away, is below the least float; the ratio to the row's best is
  // not.
  Field field(open_ground, MoveRule::free, 1, 40, [](std::size_t, int d) { return 1 / (700.0 + d); });
  const std::size_t middle = field.at(1, 1);
  for (int d = 1; d < direction_count; ++d) {
    EXPECT_GT(field.trail.weight(middle, d), 0);
    EXPECT_LT(field.trail.weight(middle, d), field.trail.weight(middle, d - 1));
  }
}

TEST(Trail, LargePowersOfPheromoneKeepTheOrderOfTheSteps) {
  // 10^20 in proportion after a hundred iterations, far from the range of floats when taken as it is.
  Field field(open_ground, MoveRule::free, 20, 1, equal, 8);
  const std::size_t middle = field.at(1, 1);
  for (int i = 0; i < 100; ++i) {
    field.trail.evaporate(0.7);
    field.trail.deposit(middle, 0, 1, false);
    field.trail.deposit(middle, 1, 0.5, false);
  }
  EXPECT_GT(field.trail.weight(middle, 0), field.trail.weight(middle, 1));
  EXPECT_GT(field.trail.weight(middle, 1), field.trail.weight(middle, 2));
  EXPECT_GT(field.trail.weight(middle, 2), 0);
}

// Random evaporation, deposits, penalties and limits on both trails.
template <typename Compare>
void compare_with_sweep(double alpha, const Compare& compare) {
  Stream stream(71);
  Field field(open_ground, MoveRule::free, alpha, 1, equal, 8);
  SweptTrail swept(field.moves.size(), 8);
  const auto both = [&](auto&& action) {
    action(field.trail);
    action(swept);
  };
  both([](auto& trail) { trail.limit(0.0625, 64); });
  for (int iteration = 0; iteration < 400; ++iteration) {
    const double persistence = 0.6 + 0.4 * stream.uniform();
    both([&](auto& trail) { trail.evaporate(persistence); });
    for (int k = 0; k < 6; ++k) {
      const std::size_t index = field.at(stream.between(0, 2), stream.between(0, 2));
      const int d = stream.between(0, 7);
      const double factor = stream.chance(0.3) ? 0.5 : 1;
      const double amount = 4 * stream.uniform();
      both([&](auto& trail) { trail.change(index, d, factor, amount); });
    }
    if (stream.chance(0.02)) {
      const double lower = std::exp2(-stream.between(2, 6));
      const double upper = std::exp2(stream.between(1, 6));
      both([&](auto& trail) { trail.limit(lower, upper); });
    }
    for (std::size_t index = 0; index < field.moves.size(); ++index) {
      if (field.moves[index] == 0) continue;
      for (int d = 0; d < direction_count; ++d) {
        compare(field.trail.pheromone(index, d), swept.at(index, d), iteration);
      }
    }
  }
}

TEST(Trail, EqualsASweptTrailWithinTheRoundingOfItsOwnAdditions) {
  // Each change rounds to 24 bits twice; 400 iterations change a step 7 times on average, rarely 30 times.
  // The limits rewrite the trail about 8 times more.
  for (const double alpha : {1.0, 2.0}) {
    compare_with_sweep(alpha, [](double lazy, double swept, int iteration) {
      ASSERT_NEAR(lazy, swept, swept * 100 * 0x1p-24) << iteration;
    });
  }
}

// Walks that turn back and cross themselves.
TEST(Trail, AlongAPathAndStepByStepAreTheSameBits) {
  const std::vector<std::string> rows(5, ".......");
  for (const double alpha : {1.0, 2.0}) {
    for (const bool both_ways : {false, true}) {
      Stream stream(5);
      Field single(rows, MoveRule::free, alpha, 1, equal);
      Field along(rows, MoveRule::free, alpha, 1, equal);
      for (Field* field : {&single, &along}) field->trail.limit(0.25, 9);
      for (int k = 0; k < 100; ++k) {
        const std::size_t first = single.at(stream.between(0, 6), stream.between(0, 4));
        std::vector<std::uint8_t> walk = random_walk(single.moves, first, stream);
        walk.resize(static_cast<std::size_t>(stream.between(0, 60)));
        const double factor = k % 3 == 0 ? 0.7 : 1;
        const double amount = stream.uniform();
        std::size_t index = first;
        for (const std::uint8_t d : walk) {
          single.trail.change(index, d, factor, amount, both_ways);
          index = single.moves.step(index, d);
        }
        along.trail.change_along(first, walk, factor, amount, both_ways);
        for (Field* field : {&single, &along}) field->trail.evaporate(0.9);
      }
      for (std::size_t i = 0; i < single.moves.size(); ++i) {
        for (int d = 0; d < direction_count; ++d) {
          EXPECT_EQ(along.trail.pheromone(i, d), single.trail.pheromone(i, d)) << i << ' ' << d;
          EXPECT_EQ(along.trail.weight(i, d), single.trail.weight(i, d)) << i << ' ' << d;
        }
      }
    }
  }
}

TEST(Trail, AClosedStepWeighsNothing) {
  Field field(open_ground, MoveRule::free, 1, 1, equal);
  const std::size_t middle = field.at(1, 1);
  field.trail.close(middle, 4);
  EXPECT_EQ(field.trail.weight(middle, 4), 0);
  field.trail.deposit(middle, 4, 5, true);
  EXPECT_EQ(field.trail.weight(middle, 4), 0);
  EXPECT_GT(field.trail.weight(middle, 5), 0);
}

}  // namespace
}  // namespace pathrace::algorithms
