// The floor baselines: what greed and blind luck do.
#include <gtest/gtest.h>

#include <set>

#include "scenarios/library.hpp"
#include "tests/support/trials.hpp"

namespace pathrace::testing {
namespace {

Budget evaluations(std::uint64_t count) {
  Budget budget;
  budget.evaluations = count;
  return budget;
}

TEST(Greedy, WalksStraightOverOpenGround) {
  const TrialRecord record = run({"greedy"}, scenario_of({OccupancyGrid(12, 12), {0, 0}, {11, 11}}));
  ASSERT_EQ(record.verdict, Verdict::solved);
  EXPECT_EQ(record.metrics->lattice, (LatticeLength{0, 11}));
}

TEST(Greedy, GivesUpInABlindAlley) {
  const Question alley{grid_of({".......", ".####..", "....#..", ".####..", "......."}), {0, 2}, {6, 2}};
  EXPECT_EQ(run({"greedy"}, scenario_of(alley)).verdict, Verdict::gave_up);
}

TEST(RandomWalk, ItsPathHasNoLoops) {
  const Scenario scenario = scenario_of({OccupancyGrid(8, 8), {0, 0}, {7, 7}});
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const TrialRecord record =
        run({"random-walk:max_steps=1000000", evaluations(1), "serial", 1, seed}, scenario);
    ASSERT_EQ(record.verdict, Verdict::solved);
    std::set<std::pair<double, double>> cells;
    for (const Point point : record.answer->points) cells.insert({point.x, point.y});
    EXPECT_EQ(cells.size(), record.answer->points.size());
    EXPECT_GT(record.work.checks, cells.size());  // the walk itself was longer
  }
}

TEST(RandomWalk, MoreWalksNeverMakeItWorse) {
  const Scenario scenario = scenarios::Library().load("dense/10-20/1");
  double last = 1e9;
  for (const std::uint64_t count : {1U, 10U, 100U, 1000U}) {
    const TrialRecord record = run({"random-walk", evaluations(count)}, scenario);
    ASSERT_EQ(record.verdict, Verdict::solved);
    EXPECT_LE(record.metrics->length, last);
    last = record.metrics->length;
  }
}

TEST(RandomWalk, GivesUpWhereThereIsNoWay) {
  const TrialRecord record =
      run({"random-walk", evaluations(5)}, scenario_of({grid_of({"..#."}), {0, 0}, {3, 0}}));
  EXPECT_EQ(record.verdict, Verdict::budget);
  EXPECT_EQ(record.work.evaluations, 5U);
  EXPECT_EQ(record.work.checks, 5U * 20 * 3);  // twenty times the free cells, five times
}

}  // namespace
}  // namespace pathrace::testing
