// Where OMPL's planners may be and go, against an oracle that looks at every blocked cell and clips the
// segment at its square, in longer numbers.
#ifdef PATHRACE_OMPL

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "baselines/ompl/free_space.hpp"
#include "core/referee.hpp"
#include "tests/support/maps.hpp"

namespace pathrace::baselines {
namespace {

using testing::grid_of;
using testing::random_grid;

constexpr auto unlimited = std::numeric_limits<std::uint64_t>::max();

// Does the segment meet the closed square around the cell, grown by this much? (Liang and Barsky's clipping.)
bool meets(Point from, Point to, Cell cell, long double growth) {
  const long double half = 0.5L + growth;
  long double in = 0;
  long double out = 1;
  const auto clip = [&](long double begin, long double way, long double centre) {
    if (way == 0) return std::fabs(begin - centre) <= half;
    const long double a = (centre - half - begin) / way;
    const long double b = (centre + half - begin) / way;
    in = std::max(in, std::min(a, b));
    out = std::min(out, std::max(a, b));
    return in <= out;
  };
  return clip(from.x, static_cast<long double>(to.x) - from.x, cell.x) &&
         clip(from.y, static_cast<long double>(to.y) - from.y, cell.y);
}

// A blocked cell, or one of the frame around the map, whose grown square the segment meets?
bool oracle_hits(const OccupancyGrid& grid, Point from, Point to, long double growth) {
  for (int y = -1; y <= grid.height(); ++y) {
    for (int x = -1; x <= grid.width(); ++x) {
      if (!grid.is_free({x, y}) && meets(from, to, {x, y}, growth)) return true;
    }
  }
  return false;
}

// Every third coordinate is a multiple of a half: on centres, edges and corners.
Point random_point(Stream& stream, const OccupancyGrid& grid) {
  const auto coordinate = [&stream](int side) {
    const double value = stream.uniform() * side - 0.5;
    return stream.below(3) == 0 ? std::round(value * 2) / 2 : value;
  };
  const double x = coordinate(grid.width());
  return {x, coordinate(grid.height())};
}

TEST(FreeSpace, AgreesWithTheOracleButForAHairAroundBlockedSquares) {
  constexpr long double margin = FreeSpace::margin;
  int free = 0;
  for (std::uint64_t i = 0; i < 4000; ++i) {
    Stream stream = Stream(41).fork(i);
    const OccupancyGrid grid =
        random_grid(stream.fork("map"), stream.between(1, 9), stream.between(1, 9), 0.2);
    const FreeSpace space(grid);
    const Point from = random_point(stream, grid);
    const Point to = random_point(stream, grid);
    const bool found = space.along(from, to, unlimited).free;
    EXPECT_FALSE(found && oracle_hits(grid, from, to, margin / 2)) << i;
    EXPECT_TRUE(found || oracle_hits(grid, from, to, 3 * margin)) << i;
    EXPECT_EQ(space.along(to, from, unlimited).free, found) << i;
    const bool here = space.at(from, unlimited).free;
    EXPECT_FALSE(here && oracle_hits(grid, from, from, margin / 2)) << i;
    EXPECT_TRUE(here || oracle_hits(grid, from, from, 3 * margin)) << i;
    free += found ? 1 : 0;
  }
  EXPECT_GT(free, 400);
}

TEST(FreeSpace, TheRefereeAcceptsWhatIsFree) {
  int judged = 0;
  for (std::uint64_t i = 0; i < 4000; ++i) {
    Stream stream = Stream(43).fork(i);
    const testing::Question question = testing::random_question(stream.fork("map"), 9, 0.25);
    const FreeSpace space(question.grid);
    Path path{Track::any_angle, {centre(question.start)}};
    for (int k = 0; k < 4; ++k) {
      const Point next = random_point(stream, question.grid);
      if (space.along(path.points.back(), next, unlimited).free) path.points.push_back(next);
    }
    if (!space.along(path.points.back(), centre(question.goal), unlimited).free) continue;
    path.points.push_back(centre(question.goal));
    const Judgement judgement =
        Referee(testing::terrain_of(question.grid)).judge(path, question.start, question.goal);
    EXPECT_TRUE(judgement.legal()) << i << ": " << judgement.fault;
    ++judged;
  }
  EXPECT_GT(judged, 400);
}

TEST(FreeSpace, NothingPassesBetweenBlockedCellsOrAlongThem) {
  const OccupancyGrid corner = grid_of({"#.", ".#"});
  EXPECT_FALSE(FreeSpace(corner).along({1, 0}, {0, 1}, unlimited).free);
  const OccupancyGrid wall = grid_of({"....", ".##.", ".##.", "...."});
  EXPECT_FALSE(FreeSpace(wall).along({0, 1.5}, {3, 1.5}, unlimited).free);
  EXPECT_FALSE(FreeSpace(wall).along({0, 0.5}, {3, 0.5}, unlimited).free);
  EXPECT_TRUE(FreeSpace(wall).along({0, 0.499}, {3, 0.499}, unlimited).free);
  EXPECT_FALSE(FreeSpace(wall).at({std::nan(""), 0}, unlimited).free);
}

TEST(FreeSpace, AnAnswerThatTheLimitCutsIsNotFreeAndCostsTheLimit) {
  const FreeSpace::Look whole = FreeSpace(OccupancyGrid(30, 1)).along({0, 0}, {29, 0}, unlimited);
  EXPECT_TRUE(whole.free);
  EXPECT_EQ(whole.cells, 30U);
  const FreeSpace::Look cut = FreeSpace(OccupancyGrid(30, 1)).along({0, 0}, {29, 0}, 29);
  EXPECT_FALSE(cut.free);
  EXPECT_EQ(cut.cells, 29U);
}

TEST(FreeSpace, TheReachEndsRightBeforeTheFirstBlockedSquare) {
  int stopped = 0;
  for (std::uint64_t i = 0; i < 4000; ++i) {
    Stream stream = Stream(47).fork(i);
    const OccupancyGrid grid = random_grid(stream.fork("map"), 9, 9, 0.2);
    const FreeSpace space(grid);
    const Point from = random_point(stream, grid);
    const Point to = random_point(stream, grid);
    const bool on_the_map = to.x >= space.low() && to.y >= space.low() && to.x <= space.high_x() &&
                            to.y <= space.high_y();  // the map's very edge is not
    if (!on_the_map || !space.at(from, unlimited).free || space.along(from, to, unlimited).free) continue;
    const auto at = [&](double t) -> Point {
      return {from.x + (to.x - from.x) * t, from.y + (to.y - from.y) * t};
    };
    const double reach = space.reach(from, to);
    ASSERT_GE(reach, 0);
    ASSERT_LT(reach, 1);
    EXPECT_TRUE(space.along(from, at(reach), unlimited).free) << i;
    const double longer = std::max(std::fabs(to.x - from.x), std::fabs(to.y - from.y));
    EXPECT_FALSE(space.along(from, at(std::min(1.0, reach + 1e-5 / longer)), unlimited).free) << i;
    ++stopped;
  }
  EXPECT_GT(stopped, 1000);
}

}  // namespace
}  // namespace pathrace::baselines

#endif
