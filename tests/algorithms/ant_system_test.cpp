// Ant System: the paper's properties.
#include <gtest/gtest.h>

#include "scenarios/library.hpp"
#include "tests/support/meeting_executor.hpp"
#include "tests/support/trials.hpp"

namespace pathrace::testing {
namespace {

Budget budget_of(std::uint64_t evaluations, std::optional<std::uint64_t> checks = std::nullopt) {
  Budget budget;
  budget.evaluations = evaluations;
  budget.checks = checks;
  return budget;
}

TEST(AntSystem, LearnsShorterPathsThanTheSameAntsWithoutPheromone) {
  const scenarios::Library library;
  int shorter = 0;
  int longer = 0;
  for (int seed = 1; seed <= 20; ++seed) {
    const Scenario scenario = library.load("dense/20-20/" + std::to_string(seed));
    const auto learning = run({"as:dead_end=backtrack,beta=2", budget_of(2000)}, scenario);
    const auto blind = run({"as:dead_end=backtrack,beta=2,alpha=0", budget_of(2000)}, scenario);
    ASSERT_EQ(learning.verdict, Verdict::solved);
    ASSERT_EQ(blind.verdict, Verdict::solved);
    shorter += learning.metrics->length < blind.metrics->length ? 1 : 0;
    longer += learning.metrics->length > blind.metrics->length ? 1 : 0;
  }
  EXPECT_GE(shorter, 15);  // a fair coin gives 15 or more of 20 with probability 0.021
  EXPECT_LE(longer, 5);
}

TEST(AntSystem, TheLastBatchOfAntsIsCutToTheBudget) {
  const Scenario scenario = scenarios::Library().load("dense/10-10/1");
  for (const std::uint64_t evaluations : {1U, 49U, 50U, 51U, 123U}) {
    const TrialRecord record = run({"as:dead_end=backtrack", budget_of(evaluations)}, scenario);
    EXPECT_EQ(record.work.evaluations, evaluations);
    EXPECT_EQ(record.work.iterations, (evaluations + 49) / 50);
  }
}

TEST(AntSystem, ChecksAreSpentToTheLastOne) {
  const Scenario scenario = scenarios::Library().load("dense/20-10/1");
  for (const std::uint64_t checks : {1U, 57U, 1000U, 4321U}) {
    const TrialRecord record = run({"as", budget_of(1'000'000, checks)}, scenario);
    EXPECT_EQ(record.work.checks, checks);
  }
}

TEST(AntSystem, ASmallerBudgetSeesTheBeginningOfALargerOnesTrace) {
  const Scenario scenario = scenarios::Library().load("dense/20-20/3");
  const TrialRecord small = run({"as:dead_end=backtrack", budget_of(500)}, scenario);
  const TrialRecord large = run({"as:dead_end=backtrack", budget_of(2000)}, scenario);
  ASSERT_LE(small.trace.size(), large.trace.size());
  for (std::size_t i = 0; i < small.trace.size(); ++i) {
    EXPECT_EQ(small.trace[i].work, large.trace[i].work);
    EXPECT_EQ(small.trace[i].cost, large.trace[i].cost);
  }
}

TEST(AntSystem, TheBestPathOfTheTraceIsTheAnswer) {
  const Scenario scenario = scenarios::Library().load("dense/20-20/4");
  const TrialRecord record = run({"as:dead_end=backtrack", budget_of(1000)}, scenario);
  ASSERT_EQ(record.verdict, Verdict::solved);
  EXPECT_EQ(record.trace.back().cost, record.metrics->length);
}

TEST(AntSystem, MoreThreadsReallyRun) {
  const Scenario scenario = scenarios::Library().load("dense/60-10/1");
  for (const std::string& backend : executors_under_test()) {
    if (backend == "serial") continue;
    const std::unique_ptr<Executor> executor = bench::make_executor(backend, 2);
    MeetingExecutor meeting(*executor);
    run_on(meeting, {"as:dead_end=backtrack,ants=200", budget_of(10000)}, scenario);
    EXPECT_TRUE(meeting.has_met()) << backend;
  }
}

}  // namespace
}  // namespace pathrace::testing
