// The yardstick navigators, each by what it is meant to do.
#include <gtest/gtest.h>

#include <cmath>

#include "baselines/navigators/disc_map.hpp"
#include "baselines/navigators/room.hpp"
#include "baselines/navigators/steer.hpp"
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

TEST(Clear, IsASegmentThatOverlapsNoDiscEvenWhereItLeavesOne) {
  World world = still_world();
  world.discs = {{{20, 50}, 5}};
  const Snapshot snapshot = snapshot_of(world);
  EXPECT_TRUE(is_clear(snapshot, {10, 43}, {30, 43}));  // 7 from the centre, more than 6
  EXPECT_FALSE(is_clear(snapshot, {10, 45}, {30, 45}));
  EXPECT_FALSE(is_clear(snapshot, {25, 50}, {40, 50}));  // begins inside
  EXPECT_TRUE(is_clear(snapshot, {40, 50}, {60, 50}));
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

// Steers by hand: the world stands still, and the plan of each step is given as points in units.
class Steered {
 public:
  explicit Steered(World world) : world_(std::move(world)) {}

  World& world() { return world_; }
  Point robot() const { return world_.start; }

  void step(const std::vector<Point>& plan) {
    world_.start = steering_.next(snapshot_of(world_), meter_, [&](const DiscMap&, std::size_t) -> Answer {
      if (plan.empty()) return std::nullopt;
      Path path{Track::any_angle, plan};
      for (Point& point : path.points) point = {point.x - 0.5, point.y - 0.5};  // cells of side 1
      return path;
    });
  }

 private:
  World world_;
  Steering steering_{1, 0.75};
  Meter meter_{Budget{}};
};

// A disc in the way of the robot at 10,50, and a way around either side of it.
World world_with_two_ways() {
  World world = still_world();
  world.discs = {{{50, 50}, 10}};
  return world;
}
const std::vector<Point> northern = {{10.5, 50.5}, {50.5, 36.5}, {90.5, 50.5}};
const std::vector<Point> southern = {{10.5, 50.5}, {50.5, 66.5}, {90.5, 50.5}};

TEST(Steering, KeepsItsWayWhileTheNewPlanIsLonger) {
  Steered run(world_with_two_ways());
  run.step(northern);
  const double once = run.robot().y;
  EXPECT_LT(once, 50);
  run.step(southern);
  EXPECT_LT(run.robot().y, once);
}

TEST(Steering, KeepsItsWayWhereThereIsNoNewPlan) {
  Steered run(world_with_two_ways());
  run.step(southern);
  const double once = run.robot().y;
  run.step({});
  EXPECT_GT(run.robot().y, once);
}

TEST(Steering, TakesAShorterPlan) {
  Steered run(world_with_two_ways());
  run.step(southern);
  const double once = run.robot().y;
  EXPECT_GT(once, 50);
  run.step(northern);
  EXPECT_LT(run.robot().y, once);
}

TEST(Steering, LeavesAWayThatADiscHasClosedFarAhead) {
  Steered run(world_with_two_ways());
  run.step(northern);
  const double once = run.robot().y;
  run.world().discs.push_back({{75, 42}, 3});  // on the second half, far from the robot
  run.step(southern);
  EXPECT_GT(run.robot().y, once);
}

TEST(Steering, ForgetsAWayThatItHasLeft) {
  Steered run(world_with_two_ways());
  run.step(northern);
  run.world().discs.push_back({{75, 42}, 3});
  run.step({});
  run.world().discs.pop_back();
  const Point waited = run.robot();
  run.step({});
  EXPECT_EQ(run.robot(), waited);
}

TEST(Steering, FollowsTheGoalAtTheEndOfAKeptWay) {
  World world = still_world();
  Steered run(world);
  run.step({{10.5, 50.5}, {90.5, 50.5}});
  run.world().goal = {13, 90};
  run.step({});
  EXPECT_GT(run.robot().y, 52);
}

// Cups whose gaps are too narrow on the map with the margin and wide enough on the map without, so that the
// ways on the two lead to opposite sides. Each of them held at least one of these navigators to the end.
TEST(MapNavigators, ArriveWhereTheirTwoMapsDisagree) {
  const scenarios::Library library;
  for (const char* id : {"discs/c-trap/7", "discs/c-trap/30", "discs/c-trap/129", "discs/c-trap/253",
                         "discs/c-trap/264", "discs/c-trap/351", "discs/c-trap/387"}) {
    const Scenario scenario = library.load(id);
    for (const char* planner : {"d-star-lite", "replan(astar)", "replan(jps)"}) {
      const TrialRecord record = run({planner}, scenario);
      ASSERT_EQ(record.verdict, Verdict::solved) << planner << " on " << id << ": " << record.note;
      EXPECT_EQ(record.run->oscillations, 0U) << planner << " on " << id;
    }
  }
}

}  // namespace
}  // namespace pathrace::baselines
