// Tan's colony: what it is with everything off, and what each improvement is for.
#include "algorithms/aco/tan/tan2016.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "scenarios/library.hpp"
#include "tests/support/oracle.hpp"
#include "tests/support/trials.hpp"

namespace pathrace::testing {
namespace {

const std::string everything_off = "amplitude=0,phi=0,mu=1,dead_table=none,deposit=1";

Budget walks(std::uint64_t count) {
  Budget budget;
  budget.evaluations = count;
  return budget;
}

TEST(Tan2016, WithEverythingOffIsAntSystemBitForBit) {
  const scenarios::Library library;
  for (const char* id : {"dense/20-20/2", "dense/20-30/5", "trap-u/20/1", "trap-l/20/4"}) {
    for (const std::string dead_end : {"die", "backtrack", "revisit_with_loop_erasure"}) {
      for (const std::string common : {"", ",initial_pheromone=0", ",alpha=1.5,initial_pheromone=0.1"}) {
        const Scenario scenario = library.load(id);
        const TrialRecord as = run({"as:deposit=1,dead_end=" + dead_end + common, walks(600)}, scenario);
        const TrialRecord tan =
            run({"tan2016:" + everything_off + ",dead_end=" + dead_end + common, walks(600)}, scenario);
        EXPECT_EQ(digest(tan), digest(as)) << id << ' ' << dead_end << common;
        EXPECT_EQ(tan.answer, as.answer);
        EXPECT_EQ(tan.work, as.work);
      }
    }
  }
}

TEST(Tan2016, EachImprovementAloneChangesTheSearch) {
  const Scenario scenario = scenarios::Library().load("trap-u/20/2");
  const std::uint64_t off = digest(run({"tan2016:" + everything_off, walks(600)}, scenario));
  for (const char* one : {"phi=0,mu=1,dead_table=none", "amplitude=0,mu=1,dead_table=none",
                          "amplitude=0,phi=0,dead_table=none", "amplitude=0,phi=0,mu=1"}) {
    EXPECT_NE(digest(run({"tan2016:deposit=1," + std::string(one), walks(600)}, scenario)), off) << one;
  }
}

TEST(Tan2016, AnswersWheneverThereIsAWayUnlessTheTableIsLiteral) {
  for (std::uint64_t i = 0; i < 60; ++i) {
    const Question question = random_question(Stream(151).fork(i), 14, 0.4);
    for (const MoveRule rule : all_rules) {
      const Scenario scenario = scenario_of(question, rule);
      const bool reachable = oracle_reachable(question.grid, rule, question.start, question.goal);
      for (const char* table : {"none", "per_ant", "global_dominated"}) {
        const TrialRecord record = run({std::string("tan2016:dead_table=") + table, walks(150)}, scenario);
        EXPECT_EQ(record.verdict == Verdict::solved, reachable) << i << ' ' << name(rule) << ' ' << table;
      }
      const TrialRecord literal = run({"tan2016:dead_table=global_literal", walks(150)}, scenario);
      EXPECT_NE(literal.verdict, Verdict::invalid) << literal.note;
      EXPECT_NE(literal.verdict, Verdict::crashed) << literal.note;
    }
  }
}

TEST(Tan2016, APriceOnTurnsMakesSmootherPaths) {
  const scenarios::Library library;
  int fewer = 0;
  int more = 0;
  for (int seed = 1; seed <= 60; ++seed) {
    const Scenario scenario = library.load("dense/20-10/" + std::to_string(seed));
    const TrialRecord with = run({"tan2016:phi=2", walks(2000)}, scenario);
    const TrialRecord without = run({"tan2016:phi=0", walks(2000)}, scenario);
    ASSERT_EQ(with.verdict, Verdict::solved);
    ASSERT_EQ(without.verdict, Verdict::solved);
    fewer += with.metrics->turns < without.metrics->turns ? 1 : 0;
    more += with.metrics->turns > without.metrics->turns ? 1 : 0;
  }
  // Many pairs are equal. A fair coin gives 16 or more of 22 with probability 0.026, 24 of 34 with 0.012.
  EXPECT_GE(fewer, 2 * more + 4);
}

TEST(Tan2016, ClosingDominatedCellsSavesDecisionsInPockets) {
  const scenarios::Library library;
  int saved = 0;
  for (int seed = 1; seed <= 10; ++seed) {
    const Scenario scenario = library.load("dense/20-30/" + std::to_string(seed));
    const TrialRecord with = run({"tan2016", walks(2000)}, scenario);
    const TrialRecord without = run({"tan2016:dead_table=none", walks(2000)}, scenario);
    saved += with.work.checks < without.work.checks ? 1 : 0;
  }
  EXPECT_GE(saved, 8);
}

TEST(Tan2016, GivesTheSameRecordOnEveryExecutorWhateverItsTable) {
  const Scenario scenario = scenarios::Library().load("trap-u/20/3");
  for (const char* table : {"none", "per_ant", "global_literal", "global_dominated"}) {
    const std::string call = std::string("tan2016:dead_table=") + table;
    const std::uint64_t expected = digest(run({call, walks(500)}, scenario));
    for (const std::string& backend : executors_under_test()) {
      for (const int threads : {1, 2, 4}) {
        EXPECT_EQ(digest(run({call, walks(500), backend, threads}, scenario)), expected)
            << table << ' ' << backend << ' ' << threads;
      }
    }
  }
}

TEST(Tan2016, DrawsCirclesPathAndPheromoneWithoutChangingItsRecord) {
  const Scenario scenario =
      scenario_of({grid_of({".....", ".....", "..#..", ".....", "....."}), {0, 2}, {4, 2}});
  const Entrant entrant = bench::roster().enter(parse_call("tan2016:ants=5"));
  const std::unique_ptr<Executor> executor = bench::make_executor("serial", 1);
  Overlay overlay;
  const TrialRecord drawn = bench::run_trial(entrant, scenario, Referee(scenario.terrain), walks(50),
                                             root_stream(1, scenario.id, 0), *executor, &overlay);
  ASSERT_EQ(overlay.circles.size(), 1U);
  EXPECT_DOUBLE_EQ(overlay.circles[0].radius, std::sqrt(0.5));
  EXPECT_EQ(overlay.polyline, (std::vector<Point>{{0, 2}, {2, 2}, {4, 2}}));
  ASSERT_EQ(overlay.field.size(), 25U);
  EXPECT_EQ(overlay.field[2 * 5 + 2], 0);                         // blocked
  EXPECT_GT(overlay.field[1 * 5 + 1], overlay.field[4 * 5 + 4]);  // where ants pass, and where none does
  EXPECT_EQ(digest(drawn), digest(run({"tan2016:ants=5", walks(50)}, scenario)));
}

}  // namespace
}  // namespace pathrace::testing
