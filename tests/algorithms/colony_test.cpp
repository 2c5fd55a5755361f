// Ant colonies beside Ant System: what each variant's paper promises, seen through the trail and the record.
#include "algorithms/aco/colony.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "algorithms/aco/max_min_limits.hpp"
#include "algorithms/aco/scout.hpp"
#include "scenarios/library.hpp"
#include "tests/support/backwards_executor.hpp"
#include "tests/support/trials.hpp"

namespace pathrace::algorithms {
namespace {

using pathrace::testing::grid_of;
using pathrace::testing::run;
using pathrace::testing::run_on;

const std::vector<std::string> variants = {"as", "eas", "as-rank", "mmas", "acs"};

Budget evaluations(std::uint64_t count) {
  Budget budget;
  budget.evaluations = count;
  return budget;
}

TEST(ElitistAntSystem, WithoutElitistsIsAntSystemBitForBit) {
  const Scenario scenario = scenarios::Library().load("dense/20-20/3");
  const std::string same = "dead_end=backtrack,beta=4,evaporation=0.4,initial_pheromone=2";
  const TrialRecord eas = run({"eas:elite=0," + same, evaluations(1000)}, scenario);
  const TrialRecord as = run({"as:" + same, evaluations(1000)}, scenario);
  EXPECT_EQ(digest(eas), digest(as));
  EXPECT_NE(digest(run({"eas:elite=1," + same, evaluations(1000)}, scenario)), digest(as));
}

TEST(Colony, EveryVariantAndDeadEndIsTheSameOnEveryExecutorAndNumberOfThreads) {
  const Scenario scenario = scenarios::Library().load("dense/20-20/2");
  for (const std::string& variant : variants) {
    for (const std::string dead_end : {"die", "backtrack", "revisit_with_loop_erasure"}) {
      const std::string call = variant + ":dead_end=" + dead_end;
      const TrialRecord expected = run({call, evaluations(300)}, scenario);
      for (const std::string& backend : testing::executors_under_test()) {
        for (const int threads : {1, 2, 4}) {
          const TrialRecord record = run({call, evaluations(300), backend, threads}, scenario);
          EXPECT_EQ(digest(record), digest(expected)) << call << ' ' << backend << ' ' << threads;
          EXPECT_EQ(record.counters, expected.counters) << call << ' ' << backend << ' ' << threads;
        }
      }
    }
  }
}

TEST(Colony, DepositsOfLongWalksAreSharedOutAndNothingElseChanges) {
  const Scenario scenario = scenarios::Library().load("dense/100-20/1");
  for (const std::string variant : {"as:", "eas:", "as:alpha=2,", "as:both_ways=false,", "tan2016:"}) {
    const std::string call = variant + "dead_end=backtrack,ants=60";
    const TrialRecord expected = run({call, evaluations(180)}, scenario);
    testing::BackwardsExecutor backwards;
    EXPECT_EQ(digest(run_on(backwards, {call, evaluations(180)}, scenario)), digest(expected)) << call;
    EXPECT_EQ(backwards.loops, 6) << call;  // 3 iterations: walks with their stretches, deposits
    for (const std::string& backend : testing::executors_under_test()) {
      EXPECT_EQ(digest(run({call, evaluations(180), backend, 3}, scenario)), digest(expected))
          << call << ' ' << backend;
    }
  }
}

// Its ants step back in fewer and fewer iterations: deposits are given up early, then made early.
TEST(Colony, WithAPriceOnStepsBackIsTheSameOnSeveralThreadsWhileThoseBecomeRare) {
  const Scenario scenario = scenarios::Library().load("dense/20-30/4");
  const std::string call = "tan2016:ants=10,dead_end=backtrack,answer=argmax_pheromone";
  const auto pops = [](const TrialRecord& record) {
    return std::ranges::find(record.counters, "pops", &Counter::name)->value;
  };
  const TrialRecord expected = run({call, evaluations(2500)}, scenario);
  EXPECT_GT(pops(run({call, evaluations(1500)}, scenario)), pops(run({call, evaluations(1000)}, scenario)));
  EXPECT_EQ(pops(expected), pops(run({call, evaluations(2000)}, scenario)));
  for (const std::string& backend : testing::executors_under_test()) {
    for (const int threads : {2, 3}) {
      const TrialRecord record = run({call, evaluations(2500), backend, threads}, scenario);
      EXPECT_EQ(digest(record), digest(expected)) << backend << ' ' << threads;
      EXPECT_EQ(record.counters, expected.counters) << backend << ' ' << threads;
    }
  }
}

// The answer is read off the last trail, and the last ants are cut: none of their deposits may be in it.
TEST(Colony, TheTrailIsTheSameOnSeveralThreadsWhereverTheBudgetEnds) {
  const Scenario scenario = scenarios::Library().load("dense/20-20/2");
  for (const std::string variant :
       {"as:", "eas:", "tan2016:mu=1,", "tan2016:", "as:alpha=2,", "acs:", "acs:xi=0.5,alpha=2,"}) {
    const std::string call = variant + "dead_end=backtrack,answer=argmax_pheromone";
    for (const std::uint64_t checks : {5000U, 12345U, 40000U}) {
      Budget budget = evaluations(900);
      budget.checks = checks;
      const TrialRecord expected = run({call, budget}, scenario);
      testing::BackwardsExecutor backwards;
      EXPECT_EQ(digest(run_on(backwards, {call, budget}, scenario)), digest(expected)) << call << checks;
      for (const std::string& backend : testing::executors_under_test()) {
        for (const int threads : {2, 5}) {
          EXPECT_EQ(digest(run({call, budget, backend, threads}, scenario)), digest(expected))
              << call << ' ' << checks << ' ' << backend << ' ' << threads;
        }
      }
    }
  }
}

TEST(Colony, CountsArrivalsAndStepsBack) {
  const Scenario scenario = scenarios::Library().load("trap-u/20/1");
  for (const std::string& variant : variants) {
    const TrialRecord back = run({variant + ":dead_end=backtrack", evaluations(200)}, scenario);
    ASSERT_EQ(back.counters.size(), 2U);
    EXPECT_EQ(back.counters[0], (Counter{"arrived", 200})) << variant;  // back-tracking always arrives
    EXPECT_GT(back.counters[1].value, 0U) << variant;
    const TrialRecord die = run({variant + ":dead_end=die", evaluations(200)}, scenario);
    EXPECT_LT(die.counters[0].value, 200U) << variant;
    EXPECT_EQ(die.counters[1], (Counter{"pops", 0})) << variant;
  }
}

TEST(Colony, AScoutThatHasSeenEverythingProvesThatThereIsNoWay) {
  const testing::Question question{grid_of({"..#..", "..#..", "..#.."}), {0, 1}, {4, 1}};
  for (const std::string variant : {"eas", "as-rank", "mmas", "acs"}) {
    const TrialRecord record = run({variant, evaluations(60)}, testing::scenario_of(question));
    EXPECT_EQ(record.verdict, Verdict::no_path) << variant;
    EXPECT_EQ(record.work.evaluations, 0U);
    EXPECT_EQ(record.work.checks, 11U) << variant;  // five other cells, there and back, and the last look
  }
}

TEST(Scout, MeasuresAGreedyWalkAndNotTheOptimum) {
  // Greedy by distance runs into the pocket and back out of it; eta here: 1 / distance to the goal.
  const OccupancyGrid grid = grid_of({"....#.", "...##.", "......"});
  const Nest nest({grid, MoveRule::four, {0, 0}, {5, 0}});
  const Trail trail(nest.moves(), 1, 1, 1, [&](std::size_t index, int d) {
    const Cell cell = nest.cell(nest.moves().step(index, d));
    return 1 / (0.01 + std::hypot(cell.x - 5.0, cell.y - 0.0));
  });
  const ScoutReport report = send_scout(nest, trail, 1000);
  ASSERT_TRUE(report.scout.has_value());
  // Into the pocket (3,0) and a step back to (2,0); then down, along the lowest row and up: two steps to
  // (2,0), two down, three east, two up.
  EXPECT_EQ(report.scout->length, 9);
  EXPECT_EQ(report.scout->steps, 9);
  EXPECT_EQ(report.decisions, 11U);  // and the step into the pocket and back
  EXPECT_FALSE(send_scout(nest, trail, 5).scout.has_value());
  EXPECT_FALSE(send_scout(nest, trail, 5).unreachable);
}

TEST(MaxMinLimits, AreTheFormulaOfTheArticle) {
  // p = 0.05, n = 10, avg = 4: root = 0.05^0.1 = 0.741134, (1 - root) / (3 root) = 0.116427.
  EXPECT_NEAR(least_share(0.05, 10, 4), 0.116427, 1e-5);
  EXPECT_EQ(least_share(0.05, 1, 1.2), 0.5);  // never above half the upper limit
  EXPECT_EQ(least_share(0.05, 10, 1), 0.5);   // corridors leave no choice
}

TEST(MaxMinLimits, ChoicesAreHalfTheMeanNumberOfSteps) {
  // Two by two cells under `free`: three steps from each.
  const OccupancyGrid grid = grid_of({"..", ".."});
  EXPECT_EQ(mean_choices(Nest({grid, MoveRule::free, {0, 0}, {1, 1}})), 1.5);
}

TEST(MaxMinLimits, BranchingIsOneOnATrailThatHasConverged) {
  const OccupancyGrid grid = grid_of({"....", "....", "...."});
  const Nest nest({grid, MoveRule::free, {0, 1}, {3, 1}});
  Trail trail(nest.moves(), 1, 1, 1, [](std::size_t, int) { return 1.0; });
  Walk walk;
  walk.directions = {0, 0, 0};
  trail.change_along(nest.start(), walk.directions, 1, 5, true);
  EXPECT_EQ(mean_branching(nest, trail, walk, 0.05, true), 1);  // on and back
  trail.deposit(grid.index({1, 1}), 2, 5, false);               // one branch at one of two inner cells
  EXPECT_EQ(mean_branching(nest, trail, walk, 0.05, true), 1.25);
}

// A rule that watches another one's trail at the end of each iteration.
class Watched final : public PheromoneRule {
 public:
  Watched(const ColonySettings& settings, std::uint64_t every) : PheromoneRule(settings), every_(every) {}

  double initial_pheromone(const Scout& scout) const override { return 10 / scout.length; }
  void begin(Colony& colony) override { colony.trail().limit(0.5, 2); }
  void learn(Colony& colony, const Harvest& harvest) override {
    if (harvest.iteration % every_ == 0) colony.close(colony.nest().start() + 1);
    colony.trail().evaporate(0.5);
    colony.deposit_all(harvest.count);
    for (std::size_t index = 0; index < colony.nest().size(); ++index) {
      for (int d = 0; d < direction_count; ++d) {
        inside &= colony.trail().pheromone(index, d) >= 0.5 && colony.trail().pheromone(index, d) <= 2;
      }
    }
    for (std::size_t k = 0; k < harvest.count; ++k) {
      for (const std::uint32_t cell : cells_of(colony.nest(), colony.walks()[k])) {
        entered += harvest.iteration > 0 && cell == colony.nest().start() + 1 ? 1 : 0;
      }
    }
  }

  bool inside = true;
  int entered = 0;

 private:
  std::uint64_t every_;
};

TEST(Colony, KeepsTrailsInsideTheirLimitsAndAntsOutOfClosedCells) {
  const OccupancyGrid grid = grid_of({".....", ".....", ".....", ".....", "....."});
  ColonySettings settings;
  settings.dead_end = DeadEnd::backtrack;
  Watched rule(settings, 1);
  Meter meter(evaluations(2000));
  const std::unique_ptr<Executor> executor = bench::make_executor("serial", 1);
  Context context{Stream(3), *executor, meter};
  Colony colony(rule, {grid, MoveRule::strict, {0, 0}, {4, 4}});
  EXPECT_TRUE(colony.run(context).has_value());
  EXPECT_TRUE(rule.inside);
  EXPECT_EQ(rule.entered, 0);
}

// A rule whose every ant wears the trail off; what its imprint should be is worked out beside it.
class Worn final : public PheromoneRule {
 public:
  explicit Worn(const ColonySettings& settings) : PheromoneRule(settings) {}

  double initial_pheromone(const Scout& scout) const override { return 10 / scout.length; }
  bool keeps_the_dead() const override { return true; }
  bool keeps_popped() const override { return true; }
  Imprint imprint() const override {
    return {.persistence = 0.9, .factor = 0.75, .of_the_dead = true, .on_popped = true};
  }
  double amount(const Walk& walk) const override { return 0.1 + 0.01 * static_cast<double>(walk.pops); }
  Early deposits_early() const override { return Early::yes; }

  void learn(Colony& colony, const Harvest& harvest) override {
    const Nest& nest = colony.nest();
    Trail expected = colony.trail();
    expected.evaporate(0.9);
    for (std::size_t k = 0; k < harvest.count; ++k) {
      const Walk& walk = colony.walks()[k];
      dead += walk.arrived ? 0 : 1;
      popped += walk.popped.size();
      expected.change_along(nest.start(), walk.directions, 0.75, amount(walk), true);
      for (const Step step : walk.popped) {
        expected.change(step.index, step.direction, 0.75, amount(walk), true);
      }
    }
    colony.imprint(harvest.count);
    for (std::size_t index = 0; index < nest.size(); ++index) {
      for (int d = 0; d < direction_count; ++d) {
        wrong += colony.trail().pheromone(index, d) != expected.pheromone(index, d) ? 1 : 0;
      }
    }
  }

  int dead = 0;
  std::size_t popped = 0;
  int wrong = 0;
};

TEST(Colony, LeavesTheImprintOfItsRuleWhetherEarlyOrNot) {
  // Who turns down steps into an alley of 20 cells, and out again; nobody has the steps to do so and arrive.
  const OccupancyGrid grid = grid_of({"..........", ".########.", ".........#", "########.#", ".........#"});
  ColonySettings settings;
  settings.dead_end = DeadEnd::backtrack;
  settings.max_steps = 45;
  const std::unique_ptr<Executor> serial = bench::make_executor("serial", 1);
  testing::BackwardsExecutor early;
  for (Executor* executor : {serial.get(), static_cast<Executor*>(&early)}) {
    Worn rule(settings);
    Meter meter(evaluations(1000));
    Context context{Stream(5), *executor, meter};
    Colony colony(rule, {grid, MoveRule::strict, {0, 0}, {9, 0}});
    colony.run(context);
    EXPECT_GT(rule.dead, 10) << executor->name();
    EXPECT_GT(rule.popped, 100U) << executor->name();
    EXPECT_EQ(rule.wrong, 0) << executor->name();
  }
}

// The local update leads back to the initial pheromone, and nothing else changes a step where the best path
// is not renewed.
TEST(AntColonySystem, WearsNoStepOffBelowTheInitialPheromone) {
  const Scenario scenario = scenarios::Library().load("dense/20-20/2");
  const Entrant entrant =
      bench::roster().enter(parse_call("acs:dead_end=backtrack,initial_pheromone=2,evaporation=0"));
  const auto planner = entrant.card->make(entrant.values)(scenario.terrain);
  const std::unique_ptr<Executor> serial = bench::make_executor("serial", 1);
  Meter meter(evaluations(400));
  Overlay overlay;
  Context context{Stream(6), *serial, meter, &overlay};
  planner->plan(scenario.start, scenario.goal, context);
  int free = 0;
  for (const double tau : overlay.field) {
    if (tau == 0) continue;
    ++free;
    EXPECT_NEAR(tau, 2, 1e-4);
  }
  EXPECT_GT(free, 200);
}

TEST(Colony, AVariantLearnsShorterPathsThanTheSameAntsWithoutPheromone) {
  const scenarios::Library library;
  for (const std::string variant : {"as-rank:", "acs:q0=0,", "mmas:evaporation=0.2,", "eas:elite=5,"}) {
    int shorter = 0;
    int longer = 0;
    for (int seed = 1; seed <= 12; ++seed) {
      const Scenario scenario = library.load("dense/20-20/" + std::to_string(seed));
      const auto length = [&](const std::string& alpha) {
        const TrialRecord record =
            run({variant + "dead_end=backtrack,beta=2,alpha=" + alpha, evaluations(2000)}, scenario);
        return record.metrics->length;
      };
      const double learning = length("1");
      const double blind = length("0");
      shorter += learning < blind ? 1 : 0;
      longer += learning > blind ? 1 : 0;
    }
    EXPECT_GE(shorter, 10) << variant;  // a fair coin gives 10 or more of 12 with probability 0.019
    EXPECT_LE(longer, 2) << variant;
  }
}

}  // namespace
}  // namespace pathrace::algorithms
