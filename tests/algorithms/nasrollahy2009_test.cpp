// The navigator `nasrollahy2009` on frozen worlds drawn by hand.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "algorithms/pso/disc_world.hpp"
#include "bench/executors.hpp"
#include "bench/roster.hpp"
#include "tests/support/trials.hpp"

namespace pathrace::algorithms {
namespace {

Snapshot empty_world(Point robot, Point goal) {
  Snapshot snapshot;
  snapshot.width = snapshot.height = 100;
  snapshot.robot = robot;
  snapshot.goal = goal;
  snapshot.robot_step = 3;
  snapshot.arrival = 3;
  return snapshot;
}

struct Walk {
  std::vector<Point> places;
  double travelled = 0;
  bool arrived = false;
  Work work;
  std::vector<Counter> counters;

  std::uint64_t steps() const { return places.size() - 1; }
};

// Steps through a world that stands still.
Walk walk(const std::string& call, Snapshot world, const std::vector<Disc>& discs, std::uint64_t seed = 1,
          Budget budget = {}, const std::string& backend = "serial", int threads = 1) {
  const Entrant entrant = bench::roster().enter(parse_call(call));
  const std::unique_ptr<Navigator> navigator = entrant.card->make_navigator(entrant.values)();
  const std::unique_ptr<Executor> executor = bench::make_executor(backend, threads);
  if (!budget.iterations) budget.iterations = 200;
  Meter meter(budget);
  Walk walk;
  walk.places.push_back(world.robot);
  world.discs = discs;
  for (world.step = 0; !meter.exhausted(); ++world.step) {
    walk.arrived = separation(world.robot, world.goal) <= world.arrival;
    if (walk.arrived) break;
    Context context{Stream(seed).fork(world.step), *executor, meter};
    const Point next = navigator->next(world, context);
    meter.end_iteration();
    walk.travelled += separation(world.robot, next);
    world.robot = next;
    walk.places.push_back(next);
  }
  walk.work = meter.work();
  walk.counters = meter.counters();
  return walk;
}

// Least distance from a centre to the polyline.
double clearance(const Walk& walk, Point centre) {
  double least = 1e300;
  for (std::size_t k = 1; k < walk.places.size(); ++k) {
    const Point p = walk.places[k - 1];
    const Point d{walk.places[k].x - p.x, walk.places[k].y - p.y};
    const double length2 = d.x * d.x + d.y * d.y;
    const double t = length2 == 0 ? 0 : ((centre.x - p.x) * d.x + (centre.y - p.y) * d.y) / length2;
    const double at = std::min(1.0, std::max(0.0, t));
    least = std::min(least, separation(centre, {p.x + at * d.x, p.y + at * d.y}));
  }
  return least;
}

TEST(Nasrollahy2009, WithoutObstaclesGoesStraight) {
  for (const char* call : {"nasrollahy2009", "nasrollahy2009:heading=angle",
                           "nasrollahy2009:inertia=constriction,c1=2.05,c2=2.05"}) {
    for (const Point goal : {Point{93, 50}, Point{70, 88}, Point{11, 14}}) {
      const Snapshot world = empty_world({50, 50}, goal);
      const double start = separation(world.robot, goal);
      const Walk straight = walk(call, world, {}, 3);
      ASSERT_TRUE(straight.arrived) << call;
      const double steps = std::ceil((start - world.arrival) / world.robot_step);
      EXPECT_NEAR(static_cast<double>(straight.steps()), steps, 1) << call;
      const double rest = separation(straight.places.back(), goal);
      EXPECT_LT(straight.travelled + rest, 1.01 * start) << call;
    }
  }
}

TEST(Nasrollahy2009, EveryStepHasTheLengthOfTheRobotsStepAndTheLastOneEndsOnTheGoal) {
  Snapshot world = empty_world({50, 50}, {50, 60});
  world.arrival = 0.01;
  const Walk exact = walk("nasrollahy2009", world, {});
  for (std::size_t k = 1; k + 1 < exact.places.size(); ++k) {
    EXPECT_LE(separation(exact.places[k - 1], exact.places[k]), 3 + 1e-9) << k;
  }
  EXPECT_NEAR(separation(exact.places[0], exact.places[1]), 3, 1e-9);
}

TEST(Nasrollahy2009, GoesAroundADiscOnTheLineByTheNearerSide) {
  for (const double shift : {-3.0, 3.0}) {
    const Disc disc{{50, 50 + shift}, 9};
    const Walk around = walk("nasrollahy2009:step_across=barred", empty_world({10, 50}, {90, 50}), {disc});
    ASSERT_TRUE(around.arrived) << shift;
    EXPECT_GT(clearance(around, disc.centre), disc.radius - 1e-6) << shift;
    for (const Point place : around.places) {
      if (std::abs(place.x - 50) < 4) {
        EXPECT_EQ(place.y<50, shift> 0) << shift;
      }
    }
    EXPECT_LT(around.travelled, 90) << shift;
  }
}

TEST(Nasrollahy2009, AvoidsTheSideThatTouchingDiscsClose) {
  // Alone the disc is passed below; three more that touch it from below make the way above the cheaper one.
  const std::vector<Disc> discs = {{{50, 48}, 8}, {{50, 62}, 6}, {{50, 73}, 5}, {{50, 82}, 4}};
  const Walk around = walk("nasrollahy2009", empty_world({10, 50}, {90, 50}), discs);
  ASSERT_TRUE(around.arrived);
  for (const Point place : around.places) {
    if (std::abs(place.x - 50) < 4) {
      EXPECT_LT(place.y, 48);
    }
  }
}

TEST(Nasrollahy2009, StaysWhenNoStepIsPossibleAndLeavesItsPlaceOnlyWhenTold) {
  // Inside a ring of discs that leaves no room for a step: every particle is inside a disc.
  std::vector<Disc> cage;
  for (int k = 0; k < 8; ++k) {
    const double angle = k * std::atan(1.0);
    cage.push_back({{50 + 4 * std::cos(angle), 50 + 4 * std::sin(angle)}, 2});
  }
  Budget budget;
  budget.iterations = 5;
  const Snapshot world = empty_world({50, 50}, {90, 50});
  const Walk caught = walk("nasrollahy2009", world, cage, 1, budget);
  EXPECT_EQ(caught.travelled, 0);
  EXPECT_EQ(caught.counters.at(0), (Counter{"barred", 5}));
  EXPECT_GT(walk("nasrollahy2009:stay_when_barred=false", world, cage, 1, budget).travelled, 0);
}

TEST(Nasrollahy2009, CountsParticlesAndDiscsAndNeverExceedsTheBudget) {
  const std::vector<Disc> discs = {{{40, 50}, 5}, {{60, 40}, 5}, {{60, 70}, 5}};
  const Snapshot world = empty_world({10, 50}, {90, 50});
  Budget budget;
  budget.iterations = 1;
  const Walk whole = walk("nasrollahy2009:particles=7,iterations=4", world, discs, 1, budget);
  EXPECT_EQ(whole.work.evaluations, 7U * 5U);
  EXPECT_EQ(whole.work.checks, 7U * 5U * 6U);
  for (const std::uint64_t limit : {1U, 5U, 6U, 20U, 100U, 1000U}) {
    for (auto member : {&Budget::evaluations, &Budget::checks}) {
      Budget tight;
      tight.*member = limit;
      const Walk cut = walk("nasrollahy2009:particles=7,iterations=4", world, discs, 1, tight);
      EXPECT_LE(cut.work.evaluations, tight.evaluations.value_or(limit)) << limit;
      EXPECT_LE(cut.work.checks, tight.checks.value_or(100'000)) << limit;
      EXPECT_LE(cut.steps(), limit);
    }
  }
}

TEST(Nasrollahy2009, DrawsWhereItsParticlesWereWhileTheyStillSearched) {
  // The swarms at birth and after 1, 2, 4, 8, 16 and 32 iterations.
  const Entrant entrant = bench::roster().enter(parse_call("nasrollahy2009"));
  const std::unique_ptr<Executor> executor = bench::make_executor("serial", 1);
  const Snapshot world = empty_world({50, 50}, {90, 50});
  Meter meter{Budget{}};
  Overlay overlay;
  Context context{Stream(1), *executor, meter, &overlay};
  const Point next = entrant.card->make_navigator(entrant.values)()->next(world, context);
  ASSERT_EQ(overlay.points.size(), 7U * 30U);
  for (const Point point : overlay.points) EXPECT_NEAR(separation(world.robot, point), 3, 1e-9);
  const auto born = overlay.points.begin() + 30;
  const auto behind = [&](Point point) { return point.x < 50; };
  EXPECT_GT(std::count_if(overlay.points.begin(), born, behind), 5);  // born all around
  EXPECT_LT(std::count_if(overlay.points.end() - 30, overlay.points.end(), behind), 5);
  EXPECT_EQ(overlay.polyline, (std::vector<Point>{world.robot, next, world.goal}));
}

TEST(Nasrollahy2009, TheSameSeedTakesTheSameStepsOnEveryExecutorAndNumberOfThreads) {
  const std::vector<Disc> discs = {{{35, 52}, 6}, {{60, 45}, 7}, {{74, 58}, 5}};
  const Snapshot world = empty_world({10, 50}, {90, 52});
  const std::vector<Point> expected = walk("nasrollahy2009", world, discs, 9).places;
  for (const std::string& backend : testing::executors_under_test()) {
    for (const int threads : {1, 2, 3}) {
      EXPECT_EQ(walk("nasrollahy2009", world, discs, 9, {}, backend, threads).places, expected)
          << backend << ' ' << threads;
    }
  }
  EXPECT_NE(walk("nasrollahy2009", world, discs, 10).places, expected);
}

}  // namespace
}  // namespace pathrace::algorithms
