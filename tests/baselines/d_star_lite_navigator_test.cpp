// D* Lite as a navigator among discs.
#include <gtest/gtest.h>

#include "scenarios/library.hpp"
#include "tests/support/trials.hpp"
#include "tests/support/worlds.hpp"

namespace pathrace::testing {
namespace {

std::uint64_t counted(const TrialRecord& record, std::string_view name) {
  for (const Counter& counter : record.counters) {
    if (counter.name == name) return counter.value;
  }
  return 0;
}

TEST(DStarLiteNavigator, GoesStraightWithoutDiscsAndEvaluatesOnePathPerStep) {
  const TrialRecord record = run({"d-star-lite"}, scenario_of(still_world()));
  ASSERT_EQ(record.verdict, Verdict::solved) << record.note;
  EXPECT_EQ(record.run->steps, 26U);  // ceil((80 - 3) / 3)
  EXPECT_EQ(record.work.evaluations, 26U);
  EXPECT_EQ(record.work.checks, counted(record, "planning_checks"));  // there is no disc to look at
}

TEST(DStarLiteNavigator, GoesAroundAWallOfDiscsWithoutTouchingIt) {
  World world = still_world();
  for (int i = 0; i < 5; ++i) world.discs.push_back({{50, 30 + 10.0 * i}, 5});
  const TrialRecord record = run({"d-star-lite"}, scenario_of(world));
  ASSERT_EQ(record.verdict, Verdict::solved) << record.note;
  EXPECT_GT(*record.run->min_clearance, 0);
  // Around an end of the wall and back, as the crow flies: 2 |(40, 26)| = 95.4 at least.
  EXPECT_GT(record.run->travelled, 90);
  EXPECT_LT(record.run->travelled, 110);
}

TEST(DStarLiteNavigator, StartsOncePerMapWhereTheGoalStandsAndExpandsLessThanReplanning) {
  std::uint64_t repaired = 0;
  std::uint64_t afresh = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    World world = busy_world(seed);
    world.goal_chance = 0;
    const TrialRecord repairs = run({"d-star-lite"}, scenario_of(world));
    const TrialRecord replans = run({"replan(astar)"}, scenario_of(world));
    ASSERT_EQ(repairs.verdict, Verdict::solved) << seed << ": " << repairs.note;
    ASSERT_EQ(replans.verdict, Verdict::solved) << seed << ": " << replans.note;
    EXPECT_LE(counted(repairs, "restarts"), 2U) << seed;  // with and without the margin
    repaired += counted(repairs, "planning_checks");
    afresh += counted(replans, "planning_checks");
  }
  EXPECT_LT(repaired, afresh);
}

TEST(DStarLiteNavigator, FollowsAGoalThatMoves) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const TrialRecord record = run({"d-star-lite"}, scenario_of(busy_world(seed)));
    EXPECT_EQ(record.verdict, Verdict::solved) << record.note;
    EXPECT_GT(counted(record, "restarts"),
              record.run->steps / 2);  // 1.5 cells a step leave a cell most times
  }
}

TEST(DStarLiteNavigator, WaitsWhereThereIsNoWay) {
  const Scenario ring = scenarios::Library().load("discs/ring,inside=goal/1");
  const TrialRecord record = run({"d-star-lite"}, ring);
  EXPECT_EQ(record.verdict, Verdict::budget);
  EXPECT_EQ(record.run->travelled, 0);
}

}  // namespace
}  // namespace pathrace::testing
