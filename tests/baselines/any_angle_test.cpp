// Theta*, Lazy Theta* and the proven any-angle optimum, against the oracle of the full visibility graph.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "baselines/any_angle/sight.hpp"
#include "tests/support/any_angle_oracle.hpp"
#include "tests/support/oracle.hpp"
#include "tests/support/trials.hpp"

namespace pathrace::testing {
namespace {

double length_of(const char* planner, const Question& question, MoveRule rule = MoveRule::strict) {
  const TrialRecord record = run({planner}, scenario_of(question, rule));
  EXPECT_EQ(record.verdict, Verdict::solved) << planner << ": " << record.note;
  return record.metrics ? record.metrics->length : -1;
}

TEST(InSight, IsTheRefereesRuleBetweenAllCellsOfRandomMaps) {
  for (std::uint64_t i = 0; i < 150; ++i) {
    const Question question = random_question(Stream(83).fork(i), 9, 0.4);
    const Referee referee(terrain_of(question.grid));
    for (const Cell from : free_cells_of(question.grid)) {
      for (const Cell to : free_cells_of(question.grid)) {
        const Path path{Track::any_angle, {centre(from), centre(to)}};
        ASSERT_EQ(baselines::in_sight(question.grid, from, to), referee.judge(path, from, to).legal())
            << i << ": " << from.x << ',' << from.y << " to " << to.x << ',' << to.y;
      }
    }
  }
}

TEST(AnyAngleOptimum, EqualsTheOracleOn2000RandomMaps) {
  int solved = 0;
  for (std::uint64_t i = 0; i < 2000; ++i) {
    const Question question = random_question(Stream(89).fork(i), 9, 0.5);
    const TrialRecord record = run({"any-angle-optimum"}, scenario_of(question));
    const std::optional<double> optimum = oracle_any_angle(question.grid, question.start, question.goal);
    ASSERT_EQ(record.verdict, optimum ? Verdict::solved : Verdict::no_path) << i << ' ' << record.note;
    if (!optimum) continue;
    ++solved;
    ASSERT_NEAR(record.metrics->length, *optimum, 1e-12 * (1 + *optimum)) << i;
  }
  EXPECT_GT(solved, 1000);
}

TEST(AnyAngleOptimum, BendsAroundTheCornersOfABlock) {
  // From (0,1) by the corners (0.5,0.5) and (1.5,0.5) to (2,1).
  const Question question{grid_of({"...", ".#.", "..."}), {0, 1}, {2, 1}};
  EXPECT_NEAR(length_of("any-angle-optimum", question), 1 + std::numbers::sqrt2, 1e-15);
}

TEST(AnyAngleOptimum, IsTheStraightLineOverOpenGround) {
  const Question question{OccupancyGrid(40, 30), {2, 3}, {38, 18}};
  EXPECT_EQ(length_of("any-angle-optimum", question), 39);  // 36, 15, 39
  EXPECT_EQ(length_of("theta-star", question), 39);
  EXPECT_EQ(length_of("lazy-theta-star", question), 39);
}

TEST(AnyAngleOptimum, DoesNotPassBetweenBlocksThatTouchAtACorner) {
  for (const char* planner : {"any-angle-optimum", "theta-star", "lazy-theta-star"}) {
    const Question question{grid_of({".#", "#."}), {0, 0}, {1, 1}};
    for (const MoveRule rule : all_rules) {
      EXPECT_EQ(run({planner}, scenario_of(question, rule)).verdict, Verdict::no_path) << planner;
    }
  }
}

TEST(AnyAngleOptimum, IsNoLongerThanThetaStarsPathsAndTheLatticeOptima) {
  for (std::uint64_t i = 0; i < 300; ++i) {
    const Question question = random_question(Stream(97).fork(i), 30, 0.4);
    if (!oracle_reachable(question.grid, MoveRule::strict, question.start, question.goal)) continue;
    const double optimum = length_of("any-angle-optimum", question) * (1 - 1e-12);
    for (const MoveRule rule : {MoveRule::four, MoveRule::strict, MoveRule::squeeze}) {
      EXPECT_LE(optimum, length_of("theta-star", question, rule)) << i;
      EXPECT_LE(optimum, length_of("lazy-theta-star", question, rule)) << i;
      EXPECT_LE(optimum, length_of("astar", question, rule)) << i;
    }
  }
}

TEST(AnyAngleOptimum, MirroringTransposingOrSwappingTheEndsKeepsTheLength) {
  for (std::uint64_t i = 0; i < 200; ++i) {
    const Question question = random_question(Stream(101).fork(i), 40, 0.35);
    if (!oracle_reachable(question.grid, MoveRule::strict, question.start, question.goal)) continue;
    const double length = length_of("any-angle-optimum", question);
    const Question swapped{question.grid, question.goal, question.start};
    for (const Question& other : {mirrored(question), transposed(question), swapped}) {
      EXPECT_NEAR(length_of("any-angle-optimum", other), length, 1e-12 * (1 + length)) << i;
    }
  }
}

TEST(AnyAngleOptimum, TurnsOnlyWhereABlockForcesIt) {
  for (std::uint64_t i = 0; i < 200; ++i) {
    const TrialRecord record =
        run({"any-angle-optimum"}, scenario_of(random_question(Stream(103).fork(i), 30, 0.3)));
    if (record.verdict != Verdict::solved) continue;
    const std::vector<Point>& points = record.answer->points;
    for (std::size_t k = 1; k + 1 < points.size(); ++k) {
      EXPECT_NE(points[k].x, std::floor(points[k].x));  // corners lie between cells
      EXPECT_NE(points[k].y, std::floor(points[k].y));
    }
    EXPECT_EQ(static_cast<std::size_t>(record.metrics->turns) + 2, std::max<std::size_t>(2, points.size()));
  }
}

class ThetaStar : public ::testing::TestWithParam<const char*> {};

TEST_P(ThetaStar, FindsALegalPathWheneverThereIsOne) {
  for (std::uint64_t i = 0; i < 300; ++i) {
    const Question question = random_question(Stream(107).fork(i), 14, 0.5);
    const bool reachable = oracle_reachable(question.grid, MoveRule::four, question.start, question.goal);
    for (const MoveRule rule : all_rules) {
      const TrialRecord record = run({GetParam()}, scenario_of(question, rule));
      ASSERT_EQ(record.verdict, reachable ? Verdict::solved : Verdict::no_path) << i << ' ' << record.note;
    }
  }
}

TEST_P(ThetaStar, TurnsAtTheCellBesideABlocksCornerNotAtTheCorner) {
  // From (0,1) over (1,0), which sees (2,1) but not (0,1)'s row beyond the block: two diagonals under
  // `squeeze`; under `strict` they would cut the block's corners, which a straight segment may.
  const Question question{grid_of({"...", ".#.", "..."}), {0, 1}, {2, 1}};
  EXPECT_NEAR(length_of(GetParam(), question, MoveRule::squeeze), 2 * std::numbers::sqrt2, 1e-15);
}

INSTANTIATE_TEST_SUITE_P(Both, ThetaStar, ::testing::Values("theta-star", "lazy-theta-star"));

}  // namespace
}  // namespace pathrace::testing
