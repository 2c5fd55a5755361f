// Ants and their trail, against the equations.
#include "algorithms/aco/ant.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "algorithms/aco/power.hpp"
#include "tests/support/maps.hpp"
#include "tests/support/oracle.hpp"

namespace pathrace::algorithms {
namespace {

using pathrace::testing::grid_of;

constexpr std::uint64_t no_limit = 1'000'000;
constexpr auto equal = [](std::size_t, int) { return 1.0; };

struct Field {
  Field(const std::vector<std::string>& rows, MoveRule rule, double beta, const Trail::Heuristic& eta)
      : grid(grid_of(rows)), moves(grid, rule), trail(moves, 1, 1, beta, eta) {}

  Ant ant(Cell start, Cell goal, DeadEnd dead_end) {
    return Ant({moves, trail, grid.index(start), grid.index(goal), dead_end, no_limit});
  }

  OccupancyGrid grid;
  MoveTable moves;
  Trail trail;
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
  Field field({"...", "...", "..."}, MoveRule::free, 2,
              [](std::size_t, int d) { return d == 0 ? 4.0 : 2.0; });
  const float* weights = field.trail.weights(field.grid.index({1, 1}));
  for (int d = 1; d < direction_count; ++d) EXPECT_FLOAT_EQ(weights[0] / weights[d], 4);
}

TEST(Trail, EvaporatesAndDepositsByEquationsTwoAndThree) {
  Field field({"...", "...", "..."}, MoveRule::free, 1, equal);
  const std::size_t middle = field.grid.index({1, 1});
  const std::size_t east = field.grid.index({2, 1});
  field.trail.evaporate(0.75, 0);
  field.trail.deposit(middle, 0, 0.5, true);
  EXPECT_FLOAT_EQ(field.trail.pheromone(middle, 0), 0.75F + 0.5F);
  EXPECT_FLOAT_EQ(field.trail.pheromone(east, 4), 0.75F + 0.5F);
  EXPECT_FLOAT_EQ(field.trail.pheromone(middle, 2), 0.75F);
  field.trail.deposit(middle, 2, 0.5, false);
  EXPECT_FLOAT_EQ(field.trail.pheromone(field.grid.index({1, 2}), 6), 0.75F);
}

TEST(Trail, DoesNotFallBelowItsFloor) {
  Field field({".."}, MoveRule::four, 1, equal);
  for (int i = 0; i < 200; ++i) field.trail.evaporate(0.5, 1e-3);
  EXPECT_FLOAT_EQ(field.trail.pheromone(field.grid.index({0, 0}), 0), 1e-3F);
}

TEST(Trail, RefreshBringsNewPheromoneIntoTheWeights) {
  Field field({"...", "...", "..."}, MoveRule::free, 1, equal);
  const std::size_t middle = field.grid.index({1, 1});
  field.trail.deposit(middle, 3, 4, false);
  field.trail.refresh();
  EXPECT_FLOAT_EQ(field.trail.weights(middle)[3] / field.trail.weights(middle)[0], 5);
}

TEST(Trail, LargeExponentsOnLargeMapsKeepTheOrderOfTheSteps) {
  // 1 / distance to the power 40, 700 cells away, is below the least float; the ratio to the row's best is
  // not.
  Field field({"...", "...", "..."}, MoveRule::free, 40, [](std::size_t, int d) { return 1 / (700.0 + d); });
  const float* weights = field.trail.weights(field.grid.index({1, 1}));
  for (int d = 1; d < direction_count; ++d) {
    EXPECT_GT(weights[d], 0);
    EXPECT_LT(weights[d], weights[d - 1]);
  }
}

TEST(Ant, ChoosesStepsInProportionToTheirWeights) {
  // From the middle of a plus, weights 1 : 2 : 3 : 4 to E, S, W, N; chi-square with 3 degrees of
  // freedom, 16.27 is the 99.9 % point. The first step is read off a walk of one decision.
  Field field({"#.#", "...", "#.#"}, MoveRule::four, 1, [](std::size_t, int d) { return 1.0 + d / 2; });
  Ant ant = field.ant({1, 1}, {0, 1}, DeadEnd::die);
  const Meter meter({});
  std::array<int, 4> counts{};
  constexpr int walks = 20000;
  for (int i = 0; i < walks; ++i) {
    ant.walk(Stream(41).fork(static_cast<std::uint64_t>(i)), 1, meter);
    ++counts[static_cast<std::size_t>(ant.direction(0) / 2)];
  }
  double chi_square = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    const double expected = walks * (static_cast<double>(k) + 1) / 10;
    chi_square += (counts[k] - expected) * (counts[k] - expected) / expected;
  }
  EXPECT_LT(chi_square, 16.27);
}

TEST(Ant, NeverStepsOnACellTwiceAndArrivesWithItsExactLength) {
  Field field({".....", ".....", ".....", ".....", "....."}, MoveRule::strict, 1, equal);
  Ant ant = field.ant({0, 0}, {4, 4}, DeadEnd::die);
  const Meter meter({});
  int arrived = 0;
  for (std::uint64_t i = 0; i < 300; ++i) {
    ant.walk(Stream(43).fork(i), no_limit, meter);
    const std::set<std::uint32_t> cells(ant.path().begin(), ant.path().end());
    EXPECT_EQ(cells.size(), ant.path().size());
    if (!ant.arrived()) continue;
    ++arrived;
    const LatticeLength length = ant.length();
    EXPECT_EQ(static_cast<std::size_t>(length.straight + length.diagonal) + 1, ant.path().size());
    EXPECT_EQ(ant.steps() + 1, ant.path().size());
  }
  EXPECT_GT(arrived, 0);
}

// A corridor to the goal with a blind alley that the heuristic prefers.
const std::vector<std::string> alley = {"..........", ".########.", ".........#", "########.#", ".........#"};

TEST(Ant, DiesInADeadEndWhenToldTo) {
  Field field({"...", "##.", "..."}, MoveRule::four, 1,
              [](std::size_t, int d) { return d == 0 ? 1e9 : 1e-9; });
  Ant ant = field.ant({1, 0}, {0, 0}, DeadEnd::die);
  ant.walk(Stream(1), no_limit, Meter({}));
  EXPECT_FALSE(ant.arrived());
}

TEST(Ant, BacktrackingArrivesOnEveryConnectedMap) {
  const Meter meter({});
  int solvable = 0;
  for (std::uint64_t i = 0; i < 200; ++i) {
    const testing::Question question = testing::random_question(Stream(47).fork(i), 15, 0.4);
    const MoveTable moves(question.grid, MoveRule::strict);
    const Trail trail(moves, 1, 1, 1, equal);
    Ant ant({moves, trail, question.grid.index(question.start), question.grid.index(question.goal),
             DeadEnd::backtrack, no_limit});
    ant.walk(Stream(53).fork(i), no_limit, meter);
    const bool reachable =
        testing::oracle_reachable(question.grid, MoveRule::strict, question.start, question.goal);
    EXPECT_EQ(ant.arrived(), reachable) << i;
    solvable += reachable ? 1 : 0;
  }
  EXPECT_GT(solvable, 50);
}

TEST(Ant, LoopErasureLeavesASimpleLegalPath) {
  Field field(alley, MoveRule::strict, 1, equal);
  Ant ant = field.ant({0, 0}, {9, 0}, DeadEnd::revisit_with_loop_erasure);
  const Meter meter({});
  bool turned_back = false;
  for (std::uint64_t i = 0; i < 200; ++i) {
    ant.walk(Stream(59).fork(i), no_limit, meter);
    ASSERT_TRUE(ant.arrived());
    const std::set<std::uint32_t> cells(ant.path().begin(), ant.path().end());
    EXPECT_EQ(cells.size(), ant.path().size());
    for (std::size_t k = 0; k + 1 < ant.path().size(); ++k) {
      EXPECT_NE(field.moves[ant.path()[k]] >> ant.direction(k) & 1, 0);
    }
    turned_back = turned_back || ant.steps() + 1 > ant.path().size();
  }
  EXPECT_TRUE(turned_back);  // some walks did go into the alley
}

TEST(Ant, StopsAtTheStepLimit) {
  Field field({"..................."}, MoveRule::four, 1, equal);
  Ant ant = field.ant({0, 0}, {18, 0}, DeadEnd::die);
  ant.walk(Stream(1), 7, Meter({}));
  EXPECT_FALSE(ant.arrived());
  EXPECT_EQ(ant.steps(), 7U);
}

TEST(Ant, StillChoosesWhenEveryWeightHasUnderflown) {
  Field field({"....."}, MoveRule::four, 1, equal);
  for (int i = 0; i < 20000; ++i) field.trail.evaporate(0.5, 0);
  field.trail.refresh();
  ASSERT_EQ(field.trail.weights(field.grid.index({1, 0}))[0], 0);
  Ant ant = field.ant({0, 0}, {4, 0}, DeadEnd::die);
  ant.walk(Stream(1), no_limit, Meter({}));
  EXPECT_TRUE(ant.arrived());
}

}  // namespace
}  // namespace pathrace::algorithms
