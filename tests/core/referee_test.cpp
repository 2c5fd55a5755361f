// The referee against paths judged by hand: each fault, each rule, and the any-angle rule at edges, corners
// and gaps.

#include "core/referee.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "tests/support/maps.hpp"
#include "tests/support/oracle.hpp"

namespace pathrace {
namespace {

using testing::all_rules;
using testing::grid_of;
using testing::terrain_of;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

Path any_angle(std::vector<Point> points) {
  return {Track::any_angle, std::move(points)};
}

std::string fault(const OccupancyGrid& grid, MoveRule rule, const Path& path, Cell start, Cell goal) {
  const Judgement judgement = Referee(terrain_of(grid, rule)).judge(path, start, goal);
  EXPECT_EQ(judgement.legal(), judgement.fault.empty());
  EXPECT_EQ(judgement.metrics.has_value(), judgement.legal());
  return judgement.fault;
}

// From the path's own first to its last point, which must be cells.
std::string fault(const OccupancyGrid& grid, const Path& path, MoveRule rule = MoveRule::strict) {
  const auto cell = [](Point point) { return Cell{static_cast<int>(point.x), static_cast<int>(point.y)}; };
  return fault(grid, rule, path, cell(path.points.front()), cell(path.points.back()));
}

// --- lattice ---------------------------------------------------------------------------------------

TEST(Referee, AcceptsALegalPathAndMeasuresIt) {
  const Judgement judgement =
      Referee(terrain_of(OccupancyGrid(5, 5)))
          .judge(lattice_path({{0, 0}, {1, 0}, {2, 1}, {2, 2}, {1, 2}}), {0, 0}, {1, 2});
  EXPECT_EQ(judgement.fault, "");
  ASSERT_TRUE(judgement.metrics);
  EXPECT_EQ(judgement.metrics->lattice, (LatticeLength{3, 1}));
  EXPECT_EQ(judgement.metrics->turns, 3);
  EXPECT_EQ(judgement.metrics->clearance_min, 1.0);
}

TEST(Referee, AcceptsOnePointWhenStartIsTheGoal) {
  for (const Track track : {Track::lattice, Track::any_angle}) {
    const Judgement judgement =
        Referee(terrain_of(OccupancyGrid(3, 3))).judge({track, {{1, 1}}}, {1, 1}, {1, 1});
    EXPECT_EQ(judgement.fault, "");
    EXPECT_EQ(judgement.metrics->length, 0.0);
  }
}

TEST(Referee, RefusesAnEmptyPath) {
  EXPECT_EQ(fault(OccupancyGrid(3, 3), MoveRule::strict, Path{}, {0, 0}, {0, 0}), "the path is empty");
  EXPECT_EQ(fault(OccupancyGrid(3, 3), MoveRule::strict, any_angle({}), {0, 0}, {0, 0}), "the path is empty");
}

TEST(Referee, RefusesAPathWithOtherEnds) {
  const Path path = lattice_path({{1, 0}, {2, 0}});
  EXPECT_EQ(fault(OccupancyGrid(3, 1), MoveRule::strict, path, {0, 0}, {2, 0}),
            "begins at 1,0, not at the start 0,0");
  EXPECT_EQ(fault(OccupancyGrid(3, 1), MoveRule::strict, path, {1, 0}, {0, 0}),
            "ends at 2,0, not at the goal 0,0");
  EXPECT_EQ(fault(OccupancyGrid(3, 1), MoveRule::strict, path, {2, 0}, {1, 0}),
            "begins at 1,0, not at the start 2,0");  // the right way, walked backwards
}

TEST(Referee, RefusesJumpsAndPauses) {
  const OccupancyGrid grid(5, 5);
  EXPECT_EQ(fault(grid, lattice_path({{0, 0}, {2, 0}})), "0,0 to 2,0 is not a step");
  EXPECT_EQ(fault(grid, lattice_path({{0, 0}, {1, 2}})), "0,0 to 1,2 is not a step");
  EXPECT_EQ(fault(grid, lattice_path({{0, 0}, {1, 0}, {1, 0}})), "1,0 to 1,0 is not a step");
  EXPECT_EQ(fault(grid, lattice_path({{4, 0}, {0, 1}})), "4,0 to 0,1 is not a step");  // no wrapping round
}

TEST(Referee, RefusesBlockedCellsAndCellsOutside) {
  const OccupancyGrid grid = grid_of({".#.", "..."});
  EXPECT_EQ(fault(grid, lattice_path({{0, 0}, {1, 0}, {2, 0}})), "1,0 is blocked");
  EXPECT_EQ(fault(grid, lattice_path({{1, 0}})), "1,0 is blocked");
  EXPECT_EQ(fault(grid, lattice_path({{0, 0}, {0, -1}, {0, 0}})), "0,-1 is outside the map");
  EXPECT_EQ(fault(grid, lattice_path({{2, 1}, {3, 1}, {2, 1}})), "3,1 is outside the map");
  EXPECT_EQ(fault(grid, lattice_path({{0, 1}, {0, 2}, {0, 1}})), "0,2 is outside the map");
}

TEST(Referee, RefusesLatticePointsThatAreNoCells) {
  const OccupancyGrid grid(3, 1);
  EXPECT_EQ(fault(grid, Path{Track::lattice, {{0, 0}, {0.5, 0}, {1, 0}}}), "0.5,0 is not a cell");
  EXPECT_EQ(fault(grid, Path{Track::lattice, {{0, 0}, {nan, 0}, {1, 0}}}), "nan,0 is not a cell");
  EXPECT_EQ(fault(grid, Path{Track::lattice, {{0, 0}, {0, infinity}, {1, 0}}}), "0,inf is not a cell");
  EXPECT_EQ(fault(grid, Path{Track::lattice, {{0, 0}, {-1e300, 0}, {1, 0}}}), "-1e+300,0 is not a cell");
  EXPECT_EQ(fault(grid, Path{Track::lattice, {{0, 0}, {4294967297.0, 0}, {1, 0}}}),
            "4294967297,0 is not a cell");  // 2^32 + 1
}

TEST(Referee, RefusesNotANumberAtTheEnds) {
  for (const Track track : {Track::lattice, Track::any_angle}) {
    EXPECT_NE(fault(OccupancyGrid(3, 1), MoveRule::strict, Path{track, {{nan, 0}, {1, 0}}}, {0, 0}, {1, 0}),
              "");
    EXPECT_NE(fault(OccupancyGrid(3, 1), MoveRule::strict, Path{track, {{0, 0}, {1, nan}}}, {0, 0}, {1, 0}),
              "");
  }
}

TEST(Referee, JudgesADiagonalByItsSideCellsUnderEachRule) {
  struct Case {
    OccupancyGrid grid;
    bool four, strict, squeeze, free;
  };
  const Case cases[] = {
      {grid_of({"..", ".."}), false, true, true, true},
      {grid_of({".#", ".."}), false, false, true, true},
      {grid_of({"..", "#."}), false, false, true, true},
      {grid_of({".#", "#."}), false, false, false, true},
  };
  const Path path = lattice_path({{0, 0}, {1, 1}});
  const std::string cut = "0,0 to 1,1 cuts a corner under the rule '";
  for (const Case& c : cases) {
    EXPECT_EQ(fault(c.grid, path, MoveRule::four), c.four ? "" : cut + "four'");
    EXPECT_EQ(fault(c.grid, path, MoveRule::strict), c.strict ? "" : cut + "strict'");
    EXPECT_EQ(fault(c.grid, path, MoveRule::squeeze), c.squeeze ? "" : cut + "squeeze'");
    EXPECT_EQ(fault(c.grid, path, MoveRule::free), c.free ? "" : cut + "free'");
  }
}

TEST(Referee, AgreesWithTheOracleOnEveryStepOfRandomMaps) {
  const Stream seeds(1);
  for (std::uint64_t i = 0; i < 40; ++i) {
    const OccupancyGrid grid = testing::random_question(seeds.fork(i), 7).grid;
    for (const MoveRule rule : all_rules) {
      const Referee referee(terrain_of(grid, rule));
      for (const Cell from : testing::free_cells_of(grid)) {
        for (int k = 0; k < 25; ++k) {
          const Cell to{from.x + k % 5 - 2, from.y + k / 5 - 2};
          ASSERT_EQ(referee.judge(lattice_path({from, to}), from, to).legal(),
                    testing::oracle_step(grid, rule, from, to))
              << name(rule) << " map " << i << ": " << from.x << "," << from.y << " to " << to.x << ","
              << to.y;
        }
      }
    }
  }
}

// --- any angle -------------------------------------------------------------------------------------

const char* const legal = "";

TEST(AnyAngleReferee, LetsASegmentTouchACorner) {
  // From 0,0 to 3,1 through 1.5,0.5, the lower right corner of 1,0 turned round: 2,0 and 1,1 are blocked
  // beside the line, which only touches them.
  EXPECT_EQ(fault(grid_of({"..#.", "...."}), any_angle({{0, 0}, {3, 1}})), legal);
  EXPECT_EQ(fault(grid_of({"....", ".#.."}), any_angle({{0, 0}, {3, 1}})), legal);
  EXPECT_EQ(fault(grid_of({"..", ".."}), any_angle({{0, 0}, {1, 1}})), legal);
  EXPECT_EQ(fault(grid_of({".#", ".."}), any_angle({{0, 0}, {1, 1}})), legal);
}

TEST(AnyAngleReferee, LetsASegmentSlideAlongAWall) {
  EXPECT_EQ(fault(grid_of({"...", "###"}), any_angle({{0, 0}, {0.5, 0.5}, {1.5, 0.5}, {2, 0}})), legal);
  EXPECT_EQ(fault(grid_of({"...", "..."}), any_angle({{0, 0}, {0, -0.5}, {2.5, -0.5}, {2, 0}})), legal);
}

TEST(AnyAngleReferee, LetsAPathGoRoundACellAlongAllFourEdgesAndRestOnEach) {
  const Path round = any_angle({{0, 0},
                                {0.5, 0.5},
                                {1, 0.5},
                                {1, 0.5},
                                {1.5, 0.5},
                                {1.5, 1},
                                {1.5, 1},
                                {1.5, 1.5},
                                {1, 1.5},
                                {1, 1.5},
                                {0.5, 1.5},
                                {0.5, 1},
                                {0.5, 1},
                                {0.5, 0.5},
                                {0, 0}});
  EXPECT_EQ(fault(grid_of({"...", ".#.", "..."}), round), legal);
}

TEST(AnyAngleReferee, LetsAPathTurnAtACorner) {
  EXPECT_EQ(fault(grid_of({"..", "#."}), any_angle({{0, 0}, {0.5, 0.5}, {1, 1}})), legal);
  EXPECT_EQ(fault(grid_of({"...", "##.", "##."}), any_angle({{0, 0}, {1.5, 0.5}, {2, 2}})), legal);
}

TEST(AnyAngleReferee, RefusesASegmentThatEntersABlockedCell) {
  EXPECT_EQ(fault(grid_of({".#."}), any_angle({{0, 0}, {2, 0}})), "0,0 to 2,0 enters the blocked cell 1,0");
  // At x = 1.5 the line to 4,1 is at y = 0.375, an eighth inside 2,0; it is inside 1,0 until then.
  EXPECT_EQ(fault(grid_of({"..#..", "....."}), any_angle({{0, 0}, {4, 1}})),
            "0,0 to 4,1 enters the blocked cell 2,0");
  EXPECT_EQ(fault(grid_of({"...", "##."}), any_angle({{0, 0}, {1, 0.51}, {2, 0}})),
            "0,0 to 1,0.51 enters the blocked cell 1,1");
}

TEST(AnyAngleReferee, RefusesTheSlightestEntry) {
  const OccupancyGrid grid = grid_of({"...", "###"});
  EXPECT_EQ(fault(grid, any_angle({{0, 0}, {1, 0.5}, {2, 0}})), legal);
  EXPECT_NE(fault(grid, any_angle({{0, 0}, {1, std::nextafter(0.5, 1)}, {2, 0}})), legal);
}

TEST(AnyAngleReferee, RefusesAPointInsideABlockedCell) {
  const OccupancyGrid grid = grid_of({".#."});
  EXPECT_NE(fault(grid, any_angle({{1, 0}})), legal);
  EXPECT_NE(fault(grid, any_angle({{1, 0}, {1, 0}})), legal);
}

TEST(AnyAngleReferee, RefusesToPassBetweenBlockedCellsThatTouchAtACorner) {
  const OccupancyGrid grid = grid_of({".#", "#."});
  for (const MoveRule rule : all_rules) {  // the track has one rule of its own
    EXPECT_EQ(fault(grid, any_angle({{0, 0}, {1, 1}}), rule),
              "0,0 to 1,1 passes between blocked cells at 0.5,0.5");
  }
  EXPECT_NE(fault(grid, any_angle({{0, 0}, {0.5, 0.5}, {1, 1}})), legal);
  EXPECT_NE(fault(grid_of({"#.", ".#"}), any_angle({{1, 0}, {0, 1}})), legal);
  EXPECT_EQ(fault(grid_of({"...", ".#.", "#.."}), any_angle({{0, 0}, {0, 1}})), legal);  // beside it
}

// The line between two cells that share an edge is outside both open squares, and yet inside a wall.
TEST(AnyAngleReferee, RefusesToSlideBetweenBlockedCellsThatShareAnEdge) {
  const OccupancyGrid wall = grid_of({"..#..", "..#..", "..#.."});
  EXPECT_EQ(fault(wall, any_angle({{0, 0}, {0, 0.5}, {4, 0.5}, {4, 0}})),
            "0,0.5 to 4,0.5 passes between blocked cells along the edge of 2,0");
  EXPECT_EQ(fault(testing::transposed({wall, {}, {}}).grid, any_angle({{0, 0}, {0.5, 0}, {0.5, 4}, {0, 4}})),
            "0.5,0 to 0.5,4 passes between blocked cells along the edge of 0,2");
  EXPECT_EQ(fault(wall, any_angle({{0, 0}, {1, 0.5}, {1.5, 0.5}, {1, 1}})), legal);  // up to the wall only
  EXPECT_NE(fault(wall, any_angle({{0, 0}, {1.5, 0.5}, {2, 0.5}, {1.5, 0.5}, {0, 0}})), legal);
}

// Outside the map is blocked, so its edge beside a blocked cell lies between two blocked cells.
TEST(AnyAngleReferee, RefusesToSlideBetweenABlockedCellAndTheEdgeOfTheMap) {
  const OccupancyGrid wall = grid_of({"..#..", "..#.."});
  EXPECT_NE(fault(wall, any_angle({{0, 0}, {0, -0.5}, {4, -0.5}, {4, 0}})), legal);
  EXPECT_NE(fault(wall, any_angle({{0, 0}, {0, 1.5}, {4, 1.5}, {4, 0}})), legal);
}

TEST(AnyAngleReferee, RefusesPointsOutsideTheMap) {
  const OccupancyGrid grid(3, 2);
  EXPECT_EQ(fault(grid, any_angle({{0, 0}, {-0.51, 0}, {0, 0}})), "-0.51,0 is outside the map");
  EXPECT_EQ(fault(grid, any_angle({{0, 0}, {2.51, 0}, {0, 0}})), "2.51,0 is outside the map");
  EXPECT_EQ(fault(grid, any_angle({{0, 0}, {0, 1.51}, {0, 0}})), "0,1.51 is outside the map");
  EXPECT_EQ(fault(grid, any_angle({{0, 0}, {nan, 0}, {0, 0}})), "nan,0 is outside the map");
  EXPECT_EQ(fault(grid, any_angle({{0, 0}, {0, -infinity}, {0, 0}})), "0,-inf is outside the map");
  EXPECT_EQ(fault(grid, any_angle({{0, 0}, {1e300, 1e300}, {0, 0}})), "1e+300,1e+300 is outside the map");
}

TEST(AnyAngleReferee, MeasuresFromThePoints) {
  const Judgement judgement =
      Referee(terrain_of(OccupancyGrid(12, 12))).judge(any_angle({{1, 1}, {4, 5}, {4, 9}}), {1, 1}, {4, 9});
  ASSERT_TRUE(judgement.metrics);
  EXPECT_DOUBLE_EQ(judgement.metrics->length, 9.0);
  EXPECT_FALSE(judgement.metrics->lattice);
}

TEST(AnyAngleReferee, MeasuresAPathThatTouchesTheLastCornerOfTheMap) {
  const OccupancyGrid grid(3, 2);
  EXPECT_EQ(fault(grid, any_angle({{0, 0}, {2.5, 1.5}, {2.5, -0.5}, {-0.5, 1.5}, {0, 0}})), legal);
}

// Slices a segment into many points: whoever has a point well inside a blocked square is illegal, whoever
// keeps every point clear of all blocked squares by a margin is legal.
TEST(AnyAngleReferee, AgreesWithDenseSamplingOnRandomSegments) {
  const Stream seeds(7);
  int entered = 0;
  int clear = 0;
  for (std::uint64_t i = 0; i < 3000; ++i) {
    const testing::Question question = testing::random_question(seeds.fork(i), 8, 0.3);
    const Point a = centre(question.start);
    const Point b = centre(question.goal);
    double deepest = -1;  // how far inside the deepest point is; negative: outside by that much
    for (int k = 0; k <= 1000; ++k) {
      const Point p{a.x + (b.x - a.x) * k / 1000, a.y + (b.y - a.y) * k / 1000};
      for (int y = 0; y < question.grid.height(); ++y) {
        for (int x = 0; x < question.grid.width(); ++x) {
          if (question.grid.is_free({x, y})) continue;
          deepest = std::fmax(deepest, 0.5 - std::fmax(std::fabs(p.x - x), std::fabs(p.y - y)));
        }
      }
    }
    const std::string verdict =
        fault(question.grid, MoveRule::strict, any_angle({a, b}), question.start, question.goal);
    if (deepest > 0.01) {
      ++entered;
      ASSERT_NE(verdict, legal) << "map " << i;
    } else if (deepest < -0.01) {
      ++clear;
      ASSERT_EQ(verdict, legal) << "map " << i;
    }
  }
  EXPECT_GT(entered, 500);
  EXPECT_GT(clear, 500);
}

}  // namespace
}  // namespace pathrace
