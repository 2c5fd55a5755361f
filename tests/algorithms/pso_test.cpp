// The planner `pso`: straight lines, ways around walls, and what its budget and parameters promise.
#include <gtest/gtest.h>

#include <cmath>

#include "algorithms/pso/waypoint_birth.hpp"
#include "algorithms/pso/waypoint_cost.hpp"
#include "scenarios/library.hpp"
#include "tests/support/trials.hpp"

namespace pathrace::algorithms {
namespace {

using testing::grid_of;
using testing::Question;
using testing::run;
using testing::scenario_of;

Budget evaluations(std::uint64_t count) {
  Budget budget;
  budget.evaluations = count;
  return budget;
}

// Of a point that is a whole number of ticks.
Tick tick_at(Point point) {
  return {static_cast<std::int32_t>((point.x + 1.5) * ticks_per_cell),
          static_cast<std::int32_t>((point.y + 1.5) * ticks_per_cell)};
}

WaypointVerdict alone(const WaypointCost& cost, std::span<const double> coordinates) {
  WaypointVerdict verdict;
  cost.judge(coordinates, {&verdict, 1});
  return verdict;
}

TEST(WaypointCost, IsTheLengthAndTheWallsOfThePolyline) {
  const WallMap walls(grid_of({".....", "..#..", "..#.."}));
  const WaypointCost cost(walls, {0, 2}, {4, 2});
  const std::vector<double> across = {1, 3, 2, 2};  // x of both way-points, then y
  EXPECT_EQ(alone(cost, across).length, 4);
  EXPECT_EQ(alone(cost, across).walls, 1U);
  const std::vector<double> around = {1, 3, 0, 0};
  EXPECT_DOUBLE_EQ(alone(cost, around).length, 2 + 2 * std::sqrt(5.0));
  EXPECT_EQ(alone(cost, around).walls, 0U);
  EXPECT_EQ(cost.path(around).points, (std::vector<Point>{{0, 2}, {1, 0}, {3, 0}, {4, 2}}));
}

TEST(WaypointCost, RoundsWaypointsToTicksAndDropsRepeatedPoints) {
  const WallMap walls(grid_of({"...."}));
  const WaypointCost cost(walls, {0, 0}, {3, 0});
  const std::vector<double> rough = {0.0001, 1.50001, 1.4999, 0, 0, 0};
  EXPECT_EQ(cost.path(rough).points, (std::vector<Point>{{0, 0}, {1.5, 0}, {3, 0}}));
}

TEST(WaypointCost, AbreastEachPathHasTheLengthAndTheWallsOfItsOwnSegments) {
  for (std::uint64_t map = 0; map < 40; ++map) {
    Stream stream = Stream(41).fork(map);
    // Every fourth map is too wide, or too high, for segments abreast.
    const int width = map % 4 == 2 ? 70 : stream.between(1, 30);
    const int height = map % 4 == 3 ? 70 : stream.between(1, 30);
    const OccupancyGrid grid = testing::random_grid(stream.fork("map"), width, height, 0.3);
    const WallMap walls(grid);
    const WaypointCost cost(walls, {0, 0}, {width - 1, height - 1});
    for (const std::size_t waypoints : {1U, 2U, 8U, 62U}) {
      const auto count = static_cast<std::size_t>(stream.between(1, 8));
      std::vector<double> coordinates;
      for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t k = 0; k < waypoints; ++k) coordinates.push_back((width - 1) * stream.uniform());
        for (std::size_t k = 0; k < waypoints; ++k) coordinates.push_back((height - 1) * stream.uniform());
      }
      std::vector<WaypointVerdict> verdicts(count);
      cost.judge(coordinates, verdicts);
      for (std::size_t i = 0; i < count; ++i) {
        const std::span row = std::span(coordinates).subspan(2 * waypoints * i, 2 * waypoints);
        const std::vector<Point> points = cost.path(row).points;
        double ticks = 0;
        Crossing sum;
        for (std::size_t k = 0; k + 1 < points.size(); ++k) {
          const Tick from = tick_at(points[k]);
          const Tick to = tick_at(points[k + 1]);
          const double dx = to.x - from.x;
          const double dy = to.y - from.y;
          ticks += std::sqrt(dx * dx + dy * dy);
          sum.walls += walls.cross(from, to).walls;
          sum.cells += walls.cross(from, to).cells;
        }
        EXPECT_EQ(verdicts[i].length, ticks / ticks_per_cell) << map;
        EXPECT_EQ((Crossing{verdicts[i].walls, verdicts[i].cells}), sum) << map;
      }
    }
  }
}

TEST(WaypointNursery, BirthplacesKeepToTheMapAndToTheirScatter) {
  const OccupancyGrid grid(30, 10);
  SwarmSettings settings;
  for (const Birth birth : {Birth::line, Birth::uniform}) {
    const WaypointNursery nursery(grid, {0, 5}, {29, 5}, birth, 2);
    Swarm swarm(settings, nursery.box(4, 0.5));
    double farthest = 0;
    for (std::size_t i = 0; i < swarm.size(); ++i) {
      nursery.place(swarm, i, Stream(3).fork(i));
      for (std::size_t k = 0; k < 4; ++k) {
        const double x = swarm.position(i)[k];
        const double y = swarm.position(i)[4 + k];
        EXPECT_TRUE(x >= 0 && x <= 29 && y >= 0 && y <= 9);
        EXPECT_LE(std::abs(swarm.velocity(i)[k]), 0.25 * 29);
        EXPECT_LE(std::abs(swarm.velocity(i)[4 + k]), 0.25 * 9);
        farthest = std::max({farthest, std::abs(x - 29.0 * static_cast<double>(k + 1) / 5), std::abs(y - 5)});
      }
    }
    EXPECT_EQ(farthest <= 2, birth == Birth::line);
  }
}

TEST(Pso, OnAnEmptyMapGoesStraight) {
  const Question question{OccupancyGrid(20, 14), {1, 2}, {18, 11}};
  const TrialRecord record = run({"pso", evaluations(30'000)}, scenario_of(question));
  ASSERT_EQ(record.verdict, Verdict::solved) << record.note;
  EXPECT_LT(record.metrics->length, 1.001 * std::hypot(17, 9));
}

TEST(Pso, FindsTheShortestWayAroundTheEndOfAWall) {
  // Over the upper end of the wall, past its corners (3.5, 1.5) and (4.5, 1.5).
  const Question question{
      grid_of({".........", ".........", "....#....", "....#....", "....#...."}), {0, 3}, {8, 3}};
  const double shortest = 2 * std::hypot(3.5, 1.5) + 1;
  const TrialRecord record = run({"pso", evaluations(60'000)}, scenario_of(question));
  ASSERT_EQ(record.verdict, Verdict::solved) << record.note;
  EXPECT_GE(record.metrics->length, shortest - 1e-9);
  EXPECT_LT(record.metrics->length, 1.005 * shortest);
}

TEST(Pso, SolvesDenseMapsAndMostTrapsWithinItsDefaultBudget) {
  const scenarios::Library library;
  const auto solved = [&](const std::vector<std::string>& ids) {
    int count = 0;
    for (const std::string& id : ids)
      count += run({"pso"}, library.load(id)).verdict == Verdict::solved ? 1 : 0;
    return count;
  };
  EXPECT_EQ(solved({"dense/10-20/1", "dense/10-20/2", "dense/20-20/1", "dense/20-20/2", "dense/20-20/3"}), 5);
  EXPECT_GE(
      solved({"trap-l/20/1", "trap-u/20/1", "trap-hook/20/1", "trap-nested-l/20/1", "trap-pocket/20/1",
              "trap-comb/20/1", "trap-tunnel/20/1", "trap-bug/20/1", "trap-spiral/20/1", "trap-baffle/20/1"}),
      8);
}

TEST(Pso, AnswersNothingRatherThanAPathThroughAWall) {
  const Question question{grid_of({"..#..", "..#..", "..#.."}), {0, 1}, {4, 1}};
  const TrialRecord record = run({"pso", evaluations(5'000)}, scenario_of(question));
  EXPECT_EQ(record.verdict, Verdict::budget);
  EXPECT_TRUE(record.trace.empty());
}

TEST(Pso, ALifeHasOneBirthAndItsMovesAndLivesGrowByAWaypoint) {
  const Question question{OccupancyGrid(9, 9), {0, 0}, {8, 5}};
  const TrialRecord record = run(
      {"pso:particles=10,life=4,waypoints_min=1,waypoints_max=2", evaluations(170)}, scenario_of(question));
  // 50 particles a life: three lives, and 20 particles of a fourth one.
  EXPECT_EQ(record.work.evaluations, 170U);
  EXPECT_EQ(record.work.iterations, 17U);
  ASSERT_FALSE(record.counters.empty());
  EXPECT_EQ(record.counters[0], (Counter{"lives", 4}));
  EXPECT_EQ(record.counters[1], (Counter{"clear", 170}));
}

TEST(Pso, RefusesMoreWaypointsAtLeastThanAtMost) {
  EXPECT_THROW(bench::roster().enter(parse_call("pso:waypoints_min=5,waypoints_max=4")), InputError);
}

TEST(Pso, EveryInertiaRuleAndTopologyFindsAWay) {
  const scenarios::Library library;
  for (const char* call : {"pso:inertia=linear,c1=2,c2=2", "pso:inertia=constant,w_start=0.7,c1=1.5,c2=1.5",
                           "pso:topology=global", "pso:neighbours=3", "pso:birth=uniform"}) {
    EXPECT_EQ(run({call, evaluations(60'000)}, library.load("dense/10-20/1")).verdict, Verdict::solved)
        << call;
  }
}

}  // namespace
}  // namespace pathrace::algorithms
