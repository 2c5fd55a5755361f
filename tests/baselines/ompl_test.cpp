// What the adapter to OMPL promises beyond the contract of planners: runs that repeat beside each other,
// counts that hold, parameters that reach the library, paths that the referee accepts.
#ifdef PATHRACE_OMPL

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <thread>
#include <vector>

#include "baselines/ompl/cards.hpp"
#include "baselines/ompl/random.hpp"
#include "baselines/ompl_names.hpp"
#include "scenarios/library.hpp"
#include "tests/support/sanitizers.hpp"
#include "tests/support/trials.hpp"

namespace pathrace::testing {
namespace {

Scenario dense(int seed) {
  return scenarios::Library().load("dense/20-20/" + std::to_string(seed));
}

Budget evaluations(std::uint64_t count) {
  Budget budget;
  budget.evaluations = count;
  return budget;
}

double distance(Point a, Point b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

TEST(Ompl, ItsGeneratorsAreSeededByUs) {
  EXPECT_NO_THROW(baselines::require_our_seeds());
}

TEST(Ompl, ThirtyPlannersRaceAndAtLeast27PromiseToRepeat) {
  const std::vector<PlannerCard> cards = baselines::ompl_cards();
  EXPECT_GE(cards.size(), 30U);
  EXPECT_GE(
      std::count_if(cards.begin(), cards.end(), [](const PlannerCard& card) { return card.deterministic; }),
      27);
  for (const PlannerCard& card : cards) EXPECT_EQ(card.track, Track::any_angle) << card.name;
}

TEST(Ompl, ItsNamesAreKnownWithoutTheLibrary) {
  std::vector<std::string> names;
  for (const PlannerCard& card : baselines::ompl_cards()) names.push_back(card.name);
  std::vector<std::string> known = baselines::ompl_names();
  std::sort(names.begin(), names.end());
  std::sort(known.begin(), known.end());
  EXPECT_EQ(names, known);
}

// Nothing that they suspect to be a solution holds, and so little is looked at that the budget alone would
// keep them busy for minutes.
TEST(Ompl, LazyPlannersGiveUpOnABoxedStart) {
  const Scenario boxed =
      scenario_of({grid_of({".#...", "##...", ".....", ".....", "....."}), {0, 0}, {4, 4}});
  for (const char* const planner : {"ompl-lazy-rrt", "ompl-lazy-prm"}) {
    const TrialRecord record = run({planner}, boxed);
    EXPECT_FALSE(record.answer.has_value()) << planner;
    EXPECT_EQ(record.work.iterations, 20'000U) << planner;
  }
}

std::vector<std::string> planners() {
  std::vector<std::string> names;
  for (const PlannerCard& card : baselines::ompl_cards()) names.push_back(card.name);
  return names;
}

class OmplPlanner : public ::testing::TestWithParam<std::string> {
 protected:
  TrialRecord trial(int seed) const {
    return run({GetParam(), evaluations(seed % 2 == 0 ? 350 : 900)}, dense(seed));
  }
};

// What the heap holds and which threads run beside it must not matter: trials of other seeds come between.
TEST_P(OmplPlanner, TrialsSideBySideGiveTheDigestsOfTrialsOneByOne) {
  if (testing::thread_sanitizer) GTEST_SKIP() << "the packaged library hides its atomic counts from it";
  constexpr int seeds = 4;
  std::vector<std::uint64_t> expected(seeds);
  for (int i = 0; i < seeds; ++i) {
    const TrialRecord record = trial(i + 1);
    EXPECT_NE(record.verdict, Verdict::invalid) << record.note;
    EXPECT_NE(record.verdict, Verdict::crashed) << record.note;
    expected[static_cast<std::size_t>(i)] = digest(record);
  }
  std::vector<std::uint64_t> forwards(seeds);
  std::vector<std::uint64_t> backwards(seeds);
  std::thread one([&] {
    for (int i = 0; i < seeds; ++i) forwards[static_cast<std::size_t>(i)] = digest(trial(i + 1));
  });
  std::thread other([&] {
    for (int i = seeds; i > 0; --i) backwards[static_cast<std::size_t>(i - 1)] = digest(trial(i));
  });
  one.join();
  other.join();
  EXPECT_EQ(forwards, expected);
  EXPECT_EQ(backwards, expected);
}

TEST_P(OmplPlanner, ItsTraceEndsAtTheLengthOfItsAnswer) {
  const TrialRecord record =
      run({GetParam(), evaluations(2500)}, scenario_of({OccupancyGrid(8, 8), {0, 0}, {7, 5}}));
  if (record.verdict != Verdict::solved) return;
  ASSERT_FALSE(record.trace.empty());
  EXPECT_NEAR(record.trace.back().cost, record.metrics->length, 1e-9);
}

std::string test_name(const ::testing::TestParamInfo<std::string>& info) {
  std::string text = info.param;
  std::replace(text.begin(), text.end(), '-', '_');
  return text;
}

INSTANTIATE_TEST_SUITE_P(All, OmplPlanner, ::testing::ValuesIn(planners()), test_name);

TEST(Ompl, ImprovingPlannersRecordTheirImprovements) {
  for (const char* const planner : {"ompl-rrt-star", "ompl-informed-rrt-star", "ompl-rrtx", "ompl-bit-star",
                                    "ompl-ait-star", "ompl-prm-star", "ompl-lazy-prm-star"}) {
    const Scenario scenario = dense(3);
    const TrialRecord record = run({planner, evaluations(12000)}, scenario);
    EXPECT_GE(record.trace.size(), 3U) << planner;
  }
}

TEST(Ompl, ASecondSeedGivesAnotherPath) {
  const Scenario scenario = dense(1);
  EXPECT_NE(digest(run({"ompl-rrt-connect", {}, "serial", 1, 1}, scenario)),
            digest(run({"ompl-rrt-connect", {}, "serial", 1, 2}, scenario)));
}

// A motion of the tree is at most `range` long; only the last piece, inside the goal's cell, may come on top.
TEST(Ompl, AParameterReachesTheLibrary) {
  const TrialRecord record = run({"ompl-rrt:range=0.75"}, dense(2));
  ASSERT_EQ(record.verdict, Verdict::solved) << record.note;
  const std::vector<Point>& points = record.answer->points;
  for (std::size_t i = 1; i < points.size(); ++i) EXPECT_LE(distance(points[i - 1], points[i]), 0.75 + 1e-9);
  EXPECT_GT(points.size(), 30U);  // 19 x 19 cells away
}

TEST(Ompl, SimplificationShortensAndIsCountedApart) {
  const Scenario scenario = dense(2);
  const TrialRecord raw = run({"ompl-rrt-connect", evaluations(5000)}, scenario);
  const TrialRecord simple = run({"ompl-rrt-connect:simplify=true", evaluations(5000)}, scenario);
  ASSERT_EQ(raw.verdict, Verdict::solved) << raw.note;
  ASSERT_EQ(simple.verdict, Verdict::solved) << simple.note;
  EXPECT_LT(simple.metrics->length, raw.metrics->length);
  ASSERT_EQ(simple.counters.size(), 2U);
  EXPECT_EQ(simple.counters[0].name, "simplify_evaluations");
  EXPECT_EQ(simple.work.evaluations, raw.work.evaluations + simple.counters[0].value);
  EXPECT_EQ(simple.work.checks, raw.work.checks + simple.counters[1].value);
  EXPECT_NEAR(simple.trace.front().cost, raw.metrics->length, 1e-9);
}

TEST(Ompl, ASimplifierThatRunsOutOfBudgetLeavesALegalPath) {
  for (std::uint64_t budget = 100; budget < 400; budget += 13) {
    const TrialRecord record = run({"ompl-rrt-connect:simplify=true", evaluations(budget)}, dense(4));
    EXPECT_NE(record.verdict, Verdict::invalid) << budget << ": " << record.note;
    EXPECT_LE(record.work.evaluations, budget);
  }
}

// Under every budget: paths found at its very end, too.
TEST(Ompl, SimplificationNeverCostsAPath) {
  for (const char* const planner : {"ompl-rrt-connect", "ompl-rrt-star"}) {
    int solved = 0;
    for (std::uint64_t budget = 100; budget < 4000; budget += 211) {
      const TrialRecord raw = run({planner, evaluations(budget)}, dense(4));
      const TrialRecord simple =
          run({std::string(planner) + ":simplify=true", evaluations(budget)}, dense(4));
      ASSERT_EQ(simple.verdict, raw.verdict) << planner << ", " << budget;
      if (raw.verdict != Verdict::solved) continue;
      ++solved;
      EXPECT_LE(simple.metrics->length, raw.metrics->length) << planner << ", " << budget;
    }
    EXPECT_GT(solved, 0) << planner;
  }
}

TEST(Ompl, WhatEndsByItselfBeforeItsBudgetHasGivenUp) {
  const Question split{grid_of({"..#..", "..#..", "..#.."}), {0, 1}, {4, 1}};
  Scenario scenario = scenario_of(split);
  const TrialSetting few_calls{"ompl-rrt:max_calls=3", evaluations(5000)};
  const TrialRecord record = run(few_calls, scenario);
  EXPECT_EQ(record.verdict, Verdict::gave_up);
  EXPECT_LT(record.work.evaluations, 5000U);
  scenario.any_angle_optimum.proven = true;
  EXPECT_EQ(run(few_calls, scenario).verdict, Verdict::no_path);
}

TEST(Ompl, ALimitOnCallsEndsASearchThatLooksAtNothing) {
  const TrialRecord record = run({"ompl-rrt-star:max_calls=50"}, dense(1));
  EXPECT_EQ(record.work.iterations, 50U);
  EXPECT_LT(record.work.evaluations, 20000U);
}

}  // namespace
}  // namespace pathrace::testing

#endif
