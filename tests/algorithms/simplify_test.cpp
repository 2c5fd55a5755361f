// The path simplification operator, against the oracle's rules and the referee's eyes.
#include "algorithms/aco/pu/simplify.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "core/referee.hpp"
#include "core/stream.hpp"
#include "tests/support/crooked_path.hpp"
#include "tests/support/maps.hpp"
#include "tests/support/oracle.hpp"
#include "tests/support/walks.hpp"

namespace pathrace::algorithms {
namespace {

using testing::grid_of;

std::vector<Cell> simplified(const OccupancyGrid& grid, MoveRule rule, const std::vector<Cell>& path) {
  const MoveTable moves(grid, rule);
  CornerCutter cutter(moves);
  Walk walk = testing::walk_over(path);
  const Walk before = walk;
  const bool cut = cutter.cut(grid.index(path[0]), walk.directions);
  EXPECT_EQ(cut, walk.directions != before.directions);
  std::vector<std::uint8_t> again = before.directions;
  cutter.cut(grid.index(path[0]), again);
  EXPECT_EQ(again, walk.directions);  // no trace of the first path was left
  return testing::cells_over(Nest({grid, rule, path.front(), path.back()}), walk);
}

double length_of(const std::vector<Cell>& path) {
  double length = 0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    length += std::hypot(path[i].x - path[i - 1].x, path[i].y - path[i - 1].y);
  }
  return length;
}

TEST(Simplify, ARightAngleOfStraightStepsBecomesADiagonalWhereTheRuleAllowsIt) {
  const std::vector<Cell> corner = {{0, 0}, {0, 1}, {1, 1}};
  const std::vector<Cell> diagonal = {{0, 0}, {1, 1}};
  const OccupancyGrid open = grid_of({"..", ".."});
  const OccupancyGrid one_side = grid_of({".#", ".."});
  EXPECT_EQ(simplified(open, MoveRule::strict, corner), diagonal);
  EXPECT_EQ(simplified(open, MoveRule::four, corner), corner);
  EXPECT_EQ(simplified(one_side, MoveRule::strict, corner), corner);
  EXPECT_EQ(simplified(one_side, MoveRule::squeeze, corner), diagonal);
  EXPECT_EQ(simplified(one_side, MoveRule::free, corner), diagonal);
}

TEST(Simplify, ARightAngleOfDiagonalStepsGoesStraightThroughTheFreeCellInside) {
  const std::vector<Cell> corner = {{0, 0}, {1, 1}, {2, 0}};
  EXPECT_EQ(simplified(grid_of({"...", "..."}), MoveRule::strict, corner),
            (std::vector<Cell>{{0, 0}, {1, 0}, {2, 0}}));
  EXPECT_EQ(simplified(grid_of({".#.", "..."}), MoveRule::free, corner), corner);
}

TEST(Simplify, AnAngleOf45DegreesBecomesTheStepBetweenItsEnds) {
  EXPECT_EQ(simplified(grid_of({"..", ".."}), MoveRule::strict, {{0, 0}, {1, 0}, {0, 1}}),
            (std::vector<Cell>{{0, 0}, {0, 1}}));
}

TEST(Simplify, ATurnBy45DegreesLeavesTheLattice) {
  const std::vector<Cell> corner = {{0, 0}, {0, 1}, {1, 2}};
  const OccupancyGrid open = grid_of({"..", "..", ".."});
  EXPECT_EQ(simplified(open, MoveRule::strict, corner), corner);
  const std::vector<Cell> straight = straightened(open, corner);
  EXPECT_EQ(straight, (std::vector<Cell>{{0, 0}, {1, 2}}));
  EXPECT_DOUBLE_EQ(length_of(straight), std::sqrt(5.0));
  EXPECT_EQ(straightened(grid_of({"..", ".#", ".."}), corner), corner);
}

TEST(Simplify, CutsTheLoopThatAReplacementCloses) {
  // The corner at (1,1) goes through (1,0), where the path has been before.
  const OccupancyGrid grid = grid_of({"....", "....", "...."});
  EXPECT_EQ(simplified(grid, MoveRule::four, {{1, 0}, {2, 0}, {2, 1}, {1, 1}, {0, 1}}).front(), (Cell{1, 0}));
  EXPECT_EQ(simplified(grid, MoveRule::strict, {{1, 0}, {0, 0}, {1, 1}, {2, 0}, {3, 0}}),
            (std::vector<Cell>{{1, 0}, {2, 0}, {3, 0}}));
}

TEST(Simplify, NeverLengthensNorBreaksARuleNorMovesTheEnds) {
  for (std::uint64_t i = 0; i < 300; ++i) {
    const Stream stream = Stream(131).fork(i);
    const testing::Question question = testing::random_question(stream, 12, 0.4);
    for (const MoveRule rule : testing::all_rules) {
      const std::vector<Cell> path =
          testing::crooked_path(question.grid, rule, question.start, question.goal, stream.fork(1));
      if (path.empty()) continue;
      const std::vector<Cell> result = simplified(question.grid, rule, path);
      EXPECT_EQ(result.front(), question.start);
      EXPECT_EQ(result.back(), question.goal);
      EXPECT_LE(length_of(result), length_of(path) + 1e-9);
      EXPECT_EQ(std::set<Cell>(result.begin(), result.end()).size(), result.size());
      for (std::size_t k = 1; k < result.size(); ++k) {
        ASSERT_TRUE(testing::oracle_step(question.grid, rule, result[k - 1], result[k]))
            << name(rule) << ' ' << i;
      }
    }
  }
}

TEST(Simplify, LeavesNoRedundantCorner) {
  for (std::uint64_t i = 0; i < 200; ++i) {
    const Stream stream = Stream(137).fork(i);
    const testing::Question question = testing::random_question(stream, 12, 0.3);
    const std::vector<Cell> path =
        testing::crooked_path(question.grid, MoveRule::strict, question.start, question.goal, stream.fork(1));
    if (path.empty()) continue;
    const std::vector<Cell> result = simplified(question.grid, MoveRule::strict, path);
    EXPECT_EQ(simplified(question.grid, MoveRule::strict, result), result);
    for (std::size_t k = 2; k < result.size(); ++k) {
      const Cell a = result[k - 2];
      const Cell c = result[k];
      EXPECT_FALSE(testing::oracle_step(question.grid, MoveRule::strict, a, c)) << i;
      const bool bridged =
          (a.x == c.x && std::abs(a.y - c.y) == 2) || (a.y == c.y && std::abs(a.x - c.x) == 2);
      const Cell middle{(a.x + c.x) / 2, (a.y + c.y) / 2};
      EXPECT_FALSE(bridged && result[k - 1] != middle && question.grid.is_free(middle)) << i;
    }
  }
}

TEST(LineOfSight, IsWhatTheRefereeAllows) {
  for (std::uint64_t i = 0; i < 60; ++i) {
    Stream stream = Stream(139).fork(i);
    const OccupancyGrid grid =
        testing::random_grid(stream.fork(0), 12, 10, 0.05 + 0.005 * static_cast<double>(i));
    const Referee referee(testing::terrain_of(grid));
    const std::vector<Cell> cells = testing::free_cells_of(grid);
    for (int k = 0; k < 300; ++k) {
      const Cell from = cells[stream.below(cells.size())];
      const Cell to = cells[stream.below(cells.size())];
      const Path path{Track::any_angle, {centre(from), centre(to)}};
      EXPECT_EQ(line_of_sight(grid, from, to), referee.judge(path, from, to).legal())
          << i << ": " << from.x << ',' << from.y << " to " << to.x << ',' << to.y;
    }
  }
}

TEST(Straightened, NeverLengthensAndSatisfiesTheRefereeOnTheAnyAngleTrack) {
  for (std::uint64_t i = 0; i < 300; ++i) {
    const Stream stream = Stream(149).fork(i);
    const testing::Question question = testing::random_question(stream, 14, 0.4);
    const Referee referee(testing::terrain_of(question.grid));
    for (const MoveRule rule : {MoveRule::four, MoveRule::strict, MoveRule::squeeze}) {
      const std::vector<Cell> path =
          testing::crooked_path(question.grid, rule, question.start, question.goal, stream.fork(1));
      if (path.empty()) continue;
      const std::vector<Cell> result = straightened(question.grid, path);
      EXPECT_LE(length_of(result), length_of(path) + 1e-9);
      Path answer{Track::any_angle, {}};
      for (const Cell cell : result) answer.points.push_back(centre(cell));
      EXPECT_EQ(referee.judge(answer, question.start, question.goal).fault, "") << i;
      EXPECT_EQ(straightened(question.grid, result), result);
    }
  }
}

}  // namespace
}  // namespace pathrace::algorithms
