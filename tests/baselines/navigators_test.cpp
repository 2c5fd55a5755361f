// The yardstick navigators, each by what it is meant to do.
#include <gtest/gtest.h>

#include <cmath>

#include "baselines/navigators/disc_map.hpp"
#include "baselines/navigators/room.hpp"
#include "bench/dynamic_trial.hpp"
#include "scenarios/library.hpp"
#include "tests/support/trials.hpp"
#include "tests/support/worlds.hpp"

namespace pathrace::baselines {
namespace {

using testing::run;
using testing::still_world;

Snapshot snapshot_of(const World& world) {
  return {world.width,        world.height,     world.start,
          world.robot_radius, world.robot_step, world.goal,
          world.arrival,      world.discs,      0};
}

TEST(Straight, TakesTheStepsThatTheDistanceTakes) {
  const TrialRecord record = run({"straight"}, testing::scenario_of(still_world()));
  ASSERT_EQ(record.verdict, Verdict::solved) << record.note;
  EXPECT_EQ(record.run->steps, 26U);  // ceil((80 - 3) / 3)
  EXPECT_DOUBLE_EQ(record.run->travelled, 78);
}

TEST(Straight, DrivesThroughDiscsAndIsRefusedForIt) {
  World world = still_world();
  world.discs = {{{50, 51}, 5}};
  const TrialRecord record = run({"straight"}, testing::scenario_of(world));
  EXPECT_EQ(record.verdict, Verdict::invalid);
  EXPECT_NE(record.note.find("collision"), std::string::npos);
  EXPECT_GT(record.run->collisions, 0U);
}

TEST(FreeWay, IsOneThatTouchesAtMost) {
  World world = still_world();
  world.discs = {{{20, 50}, 5}};
  const Snapshot snapshot = snapshot_of(world);
  EXPECT_TRUE(is_free_way(snapshot, {13, 50}));  // 7 from the centre, 6 are enough
  EXPECT_FALSE(is_free_way(snapshot, {14.1, 50}));
  EXPECT_FALSE(is_free_way(snapshot, {30, 50}));  // through it
  EXPECT_TRUE(is_free_way(snapshot, {30, 70}));
}

TEST(FreeWay, LeadsOutOfADiscAndNotDeeper) {
  World world = still_world();
  world.discs = {{{15, 50}, 5}};
  const Snapshot snapshot = snapshot_of(world);
  EXPECT_TRUE(is_free_way(snapshot, {8, 50}));
  EXPECT_FALSE(is_free_way(snapshot, {11, 50}));
}

TEST(PotentialField, GoesStraightWhereNoDiscIsInReach) {
  World world = still_world();
  world.discs = {{{50, 90}, 5}};
  const TrialRecord record = run({"potential-field"}, testing::scenario_of(world));
  ASSERT_EQ(record.verdict, Verdict::solved);
  EXPECT_EQ(record.run->steps, 26U);
}

TEST(PotentialField, SwervesAroundADiscBesideItsWay) {
  World world = still_world();
  world.discs = {{{50, 52}, 5}};
  const TrialRecord record = run({"potential-field"}, testing::scenario_of(world));
  ASSERT_EQ(record.verdict, Verdict::solved) << record.note;
  double highest = 100;
  for (const Point point : record.answer->points) highest = std::min(highest, point.y);
  EXPECT_LT(highest, 46);  // the disc's far side from the line: 52 - 5 - 1
}

TEST(PotentialField, StaysInADeadPointStraightBehindADisc) {
  World world = still_world();
  world.discs = {{{50, 50}, 5}};
  const TrialRecord record = run({"potential-field"}, testing::scenario_of(world));
  EXPECT_EQ(record.verdict, Verdict::budget);  // the local minimum that the method is known for
}

TEST(DiscMap, BlocksExactlyTheCentresThatTheRobotMayNotReach) {
  World world = still_world();
  world.discs = {{{40.3, 61.7}, 5}, {{70, 20}, 3}};
  for (const double resolution : {0.5, 1.0, 3.0}) {
    const DiscMap map(snapshot_of(world), resolution, 0.75);
    const OccupancyGrid& grid = *map.terrain().grid;
    ASSERT_EQ(grid.width(), static_cast<int>(std::ceil(100 / resolution)));
    for (int y = 0; y < grid.height(); ++y) {
      for (int x = 0; x < grid.width(); ++x) {
        const Point p{(x + 0.5) * resolution, (y + 0.5) * resolution};
        bool barred = p.x < 1 || p.y < 1 || p.x > 99 || p.y > 99;
        for (const Disc& disc : world.discs) {
          barred = barred || straight_line(p, disc.centre) < disc.radius + 1 + 0.75 * resolution;
        }
        ASSERT_EQ(grid.is_free({x, y}), !barred) << x << ',' << y << " at " << resolution;
      }
    }
  }
}

TEST(DiscMap, LeavesTheCellsOfRobotAndGoalFree) {
  World world = still_world();
  world.discs = {{{12, 50}, 5}, {{88, 50}, 5}};
  const DiscMap map(snapshot_of(world), 1, 0.75);
  EXPECT_TRUE(map.terrain().grid->is_free(map.cell_of(world.start)));
  EXPECT_TRUE(map.terrain().grid->is_free(map.cell_of(world.goal)));
}

TEST(Replan, GoesStraightWithoutDiscs) {
  const TrialRecord record = run({"replan(astar)"}, testing::scenario_of(still_world()));
  ASSERT_EQ(record.verdict, Verdict::solved) << record.note;
  EXPECT_EQ(record.run->steps, 26U);
}

TEST(Replan, GoesAroundAWallOfDiscsWithoutTouchingIt) {
  World world = still_world();
  for (int i = 0; i < 5; ++i) world.discs.push_back({{50, 30 + 10.0 * i}, 5});
  const TrialRecord record = run({"replan(astar)"}, testing::scenario_of(world));
  ASSERT_EQ(record.verdict, Verdict::solved) << record.note;
  EXPECT_GT(record.run->steps, 26U);
  EXPECT_GT(*record.run->min_clearance, 0);
  // Around an end of the wall and back, as the crow flies: 2 |(40, 26)| = 95.4 at least.
  EXPECT_GT(record.run->travelled, 90);
  EXPECT_LT(record.run->travelled, 110);
}

TEST(Replan, WaitsWhereThereIsNoWayAndStepsAsideFromADiscThatIsNear) {
  World world = still_world();
  // A closed ring around the goal: there is no way to it.
  const Scenario ring = scenarios::Library().load("discs/ring,inside=goal/1");
  const TrialRecord waits = run({"replan(astar)"}, ring);
  EXPECT_EQ(waits.verdict, Verdict::budget);
  EXPECT_EQ(waits.run->travelled, 0);
  world = *ring.world;
  world.max_steps = 1;
  world.disc_chance = 0;
  world.discs.push_back({{world.start.x + 5.5, world.start.y}, 4});  // a gap of 0.5
  const TrialRecord aside = run({"replan(astar)"}, testing::scenario_of(world));
  EXPECT_NEAR(aside.run->travelled, 3, 1e-12);
  EXPECT_LT(aside.answer->points.back().x, world.start.x);
  EXPECT_EQ(aside.run->collisions, 0U);
}

TEST(Replan, TakesAnyPlannerAndEachSpellingIsTheSameCall) {
  const auto& roster = bench::roster();
  const auto call = [&roster](const std::string& text) { return roster.enter(parse_call(text)); };
  EXPECT_EQ(call("replan(astar)").full_call(), call("replan").full_call());
  EXPECT_EQ(call("replan(as:ants=20)").full_call(), call("replan:planner=as:ants=20").full_call());
  EXPECT_EQ(call("replan(as:ants=20,alpha=2):resolution=2").label, "replan(as:alpha=2,ants=20):resolution=2");
  EXPECT_EQ(call("replan:resolution=2,planner=(as:ants=20)").label, "replan(as:ants=20):resolution=2");
  EXPECT_EQ(call("replan").label, "replan(astar)");
  const std::string full = call("replan(as:ants=20)").full_call();
  EXPECT_EQ(call(full).full_call(), full);
  EXPECT_NE(full.find("beta="), std::string::npos) << full;  // every parameter of the planner names the trial
}

TEST(Replan, RefusesWhatIsNoPlannerOfMaps) {
  const auto refusal = [](const std::string& text) -> std::string {
    try {
      bench::roster().enter(parse_call(text));
    } catch (const InputError& fault) {
      return fault.what();
    }
    return "";
  };
  EXPECT_NE(refusal("replan(asta)").find("'astar'"), std::string::npos);
  EXPECT_NE(refusal("replan(straight)").find("unknown planner 'straight'"), std::string::npos);
  EXPECT_NE(refusal("replan(as:ant=3)").find("'ants'"), std::string::npos);
  EXPECT_NE(refusal("replan(astar").find("')' is missing"), std::string::npos);
  EXPECT_NE(refusal("replan(astar)x").find("expected ':'"), std::string::npos);
}

}  // namespace
}  // namespace pathrace::baselines
