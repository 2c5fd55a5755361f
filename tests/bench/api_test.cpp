// The library as another program calls it.
#include <gtest/gtest.h>

#include <functional>

#include "bench/api/pathrace/pathrace.hpp"
#include "tests/support/maps.hpp"
#include "tests/support/process.hpp"

namespace pathrace {
namespace {

// 6 x 3 cells of half a metre; the way leads around the wall's lower end.
GridMap walled() {
  return map_of(testing::grid_of({"..#...", "..#...", "......"}), 0.5);
}

std::string refusal(const std::function<void()>& act) {
  try {
    act();
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Api, PlansFromCellToCell) {
  const Plan way = plan(walled(), Cell{0, 2}, Cell{5, 2}, "astar");
  ASSERT_TRUE(way);
  EXPECT_EQ(way.length, 5);
  EXPECT_EQ(way.length_m, 2.5);
  ASSERT_EQ(way.points.size(), way.points_m.size());
  EXPECT_EQ(way.points.back(), (Point{5, 2}));
}

TEST(Api, PlansInMetresFromTheLowerLeftCorner) {
  const Plan way = plan(walled(), Metres{0.1, 0.1}, Metres{2.9, 1.4}, "jps");
  ASSERT_TRUE(way);
  EXPECT_EQ(way.points.front(), (Point{0, 2}));
  EXPECT_EQ(way.points.back(), (Point{5, 0}));
  EXPECT_DOUBLE_EQ(way.points_m.front().x, 0.25);
  EXPECT_DOUBLE_EQ(way.points_m.front().y, 0.25);
  EXPECT_DOUBLE_EQ(way.points_m.back().x, 2.75);
  EXPECT_DOUBLE_EQ(way.points_m.back().y, 1.25);
}

TEST(Api, ReadsAMapAndTurnsItsFrame) {
  const testing::ScratchFolder scratch;
  scratch.file("m.pgm", "P5\n3 2\n255\n" + std::string(6, '\xfe'));
  // The frame's x axis points up the picture: a quarter turn.
  const std::string yaml = scratch.file(
      "m.yaml",
      "image: m.pgm\nresolution: 2\norigin: [10, 20, 1.5707963267948966]\nnegate: 0\noccupied_thresh: 0.65\n"
      "free_thresh: 0.196\n");
  const Plan way = plan(read_map(yaml), Cell{0, 1}, Cell{2, 1}, "astar");
  ASSERT_TRUE(way);
  EXPECT_NEAR(way.points_m.back().x, 10 - 1, 1e-9);  // one row of 2 m above the origin, half of it
  EXPECT_NEAR(way.points_m.back().y, 20 + 5, 1e-9);  // two columns and a half
}

TEST(Api, SaysThatThereIsNoWay) {
  const Plan way = plan(map_of(testing::grid_of({".#."})), Cell{0, 0}, Cell{2, 0}, "astar");
  EXPECT_FALSE(way);
  EXPECT_EQ(way.verdict, Verdict::no_path);
  EXPECT_TRUE(way.points.empty());
}

TEST(Api, TheSeedAndNotTheThreadsChooseAmongRandomPaths) {
  PlanOptions options;
  options.budget.evaluations = 40;
  const auto points = [&] {
    return plan(walled(), Cell{0, 0}, Cell{5, 0}, "as:dead_end=backtrack", options).points;
  };
  const auto alone = points();
  options.threads = 2;
  EXPECT_EQ(points(), alone);
}

TEST(Api, WrongInputIsAnExceptionThatSaysWhatIsWrong) {
  const GridMap map = walled();
  EXPECT_EQ(refusal([&] {
              plan(map, Cell{0, 0}, Cell{5, 0}, "asta");
            }),
            "unknown planner 'asta'; the nearest match is 'astar'");
  EXPECT_NE(refusal([&] { plan(map, Cell{2, 0}, Cell{5, 0}, "astar"); }).find("2,0"), std::string::npos);
  EXPECT_EQ(refusal([&] {
              plan(map, Metres{0, 0}, Metres{3.5, 0}, "astar");
            }),
            "the goal at 3.5 m, 0 m is not on the map");
  EXPECT_NE(refusal([] { read_map("/no/such.map"); }).find("/no/such.map"), std::string::npos);
  EXPECT_NE(refusal([] { map_of(OccupancyGrid(1, 1), 0); }), "accepted");
  EXPECT_THROW(plan(map, Cell{0, 0}, Cell{5, 0}, "straight"), Unsupported);
}

}  // namespace
}  // namespace pathrace
