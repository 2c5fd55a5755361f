// The price of detours around discs, against arithmetic and against the recursion as the paper states it.
#include "algorithms/pso/arc_penalty.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/stream.hpp"

namespace pathrace::algorithms {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double touching = 1e-6;

Snapshot snapshot_of(Point robot, Point goal, double robot_radius = 0) {
  Snapshot snapshot;
  snapshot.width = snapshot.height = 100;
  snapshot.robot = robot;
  snapshot.goal = goal;
  snapshot.robot_radius = robot_radius;
  snapshot.robot_step = 5;
  return snapshot;
}

// Penalty of a particle just before the robot's place: all of it is the second leg's.
double penalty(const std::vector<Disc>& discs, Point robot, Point particle, Point goal,
               LegJudge::Rules rules = {1e6, StepAcross::arc}, double robot_radius = 0) {
  const Snapshot snapshot = snapshot_of(robot, goal, robot_radius);
  return LegJudge(snapshot, grow(discs, robot_radius, {100, 100}, touching), rules).penalty(particle);
}

TEST(Chord, OfADiscOnTheLineIsADiameter) {
  const auto found = chord({10, 50}, {90, 50}, {50, 50}, 8);
  ASSERT_TRUE(found.has_value());
  EXPECT_NEAR(std::abs(found->entry), pi, 1e-12);
  EXPECT_NEAR(found->exit, 0, 1e-12);
}

TEST(Chord, IsNoneWhereTheSegmentMissesTouchesOrEndsBefore) {
  EXPECT_FALSE(chord({10, 50}, {90, 50}, {50, 59}, 8));
  EXPECT_FALSE(chord({10, 50}, {90, 50}, {50, 58}, 8));  // touches
  EXPECT_FALSE(chord({10, 50}, {30, 50}, {50, 50}, 8));
  EXPECT_FALSE(chord({70, 50}, {90, 50}, {50, 50}, 8));
  EXPECT_FALSE(chord({10, 50}, {10, 50}, {50, 50}, 8));
}

TEST(ArcPenalty, OfADiscCentredOnTheLineIsHalfItsCircumference) {
  EXPECT_NEAR(penalty({{{50, 50}, 8}}, {10, 50}, {15, 50}, {90, 50}), pi * 8, 1e-9);
  EXPECT_NEAR(penalty({{{50, 50}, 3.5}}, {20, 20}, {22, 22}, {80, 80}), pi * 3.5, 1e-9);
}

TEST(ArcPenalty, OfADiscBesideTheLineIsTheLesserArc) {
  const double rho = 8;
  for (const double h : {-7.5, -4.0, -0.5, 1.0, 4.0, 7.9}) {
    const double d = 2 * std::acos(std::abs(h) / rho);
    const double expected = rho * std::min(d, 2 * pi - d);
    EXPECT_NEAR(penalty({{{50, 50 + h}, rho}}, {10, 50}, {15, 50}, {90, 50}), expected, 1e-9) << h;
  }
}

TEST(ArcPenalty, GrowsTheDiscByTheRobot) {
  EXPECT_NEAR(penalty({{{50, 50}, 8}}, {10, 50}, {15, 50}, {90, 50}, {1e6, StepAcross::arc}, 2), pi * 10,
              1e-9);
}

TEST(ArcPenalty, IsTheSumOverDiscsAndOverBothLegs) {
  const std::vector<Disc> discs = {{{30, 50}, 4}, {{60, 50}, 6}, {{60, 80}, 6}};
  EXPECT_NEAR(penalty(discs, {10, 50}, {15, 50}, {90, 50}), pi * (4 + 6), 1e-9);
  // The robot's own leg crosses the first disc, the second leg the other one.
  EXPECT_NEAR(penalty(discs, {10, 50}, {40, 50}, {90, 50}), pi * (4 + 6), 1e-9);
  EXPECT_EQ(penalty(discs, {10, 50}, {15, 50}, {20, 90}), 0);
}

TEST(ArcPenalty, OfManyDiscsApartIsTheSumOfEachAlone) {
  std::vector<Disc> discs;
  for (int i = 0; i < 5; ++i) {
    for (int j = 0; j < 5; ++j) {
      if (i + j > 0 && i + j < 8) discs.push_back({{10.0 + 20 * i, 10.0 + 20 * j}, 4.0 + 0.2 * j});
    }
  }
  ASSERT_EQ(discs.size(), 23U);  // no multiple of any vector's length
  Stream stream(5);
  double most = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    const Point robot{100 * stream.uniform(), 100 * stream.uniform()};
    const Point particle{100 * stream.uniform(), 100 * stream.uniform()};
    const Point goal{100 * stream.uniform(), 100 * stream.uniform()};
    double expected = 0;
    for (const Disc& disc : discs) expected += penalty({disc}, robot, particle, goal);
    ASSERT_EQ(penalty(discs, robot, particle, goal), expected) << trial;
    most = std::max(most, expected);
  }
  EXPECT_GT(most, 1e6);  // particles inside discs among them
}

// One disc, asked about each leg without the sieve for many.
double plain_penalty(const Disc& disc, Point robot, Point particle, Point goal, double barrier) {
  const Obstacle obstacle = grow(std::vector{disc}, 0, {1e6, 1e6}, touching)[0];
  if (const double depth = depth_in(obstacle, particle); depth > 0) return barrier + depth;
  double sum = 0;
  for (const auto& [from, to, end] : {std::array{robot, particle, robot}, {particle, goal, goal}}) {
    const std::optional<Chord> found = chord(from, to, disc.centre, disc.radius);
    if (found && depth_in(obstacle, end) == 0) sum += std::min(barrier, way_around(obstacle, *found));
  }
  return sum;
}

TEST(ArcPenalty, ADiscThatALegAllButTouchesCountsByTheHeightOfItsChord) {
  constexpr double barrier = 1e6;
  int crossed = 0;
  int missed = 0;
  for (std::uint64_t trial = 0; trial < 20'000; ++trial) {
    Stream stream = Stream(61).fork(trial);
    const auto anywhere = [&] { return Point{40 + 20 * stream.uniform(), 40 + 20 * stream.uniform()}; };
    const Point robot = anywhere();
    const Point particle = anywhere();
    const Point goal = anywhere();
    // A disc beside a place of either leg, whose edge is 10^-1 to 10^-16 radii before or behind the leg.
    const Point from = trial % 2 == 0 ? robot : particle;
    const Point to = trial % 2 == 0 ? particle : goal;
    const Point way{to.x - from.x, to.y - from.y};
    const double radius = std::pow(10, -4 + 5 * stream.uniform());
    const double hair = (stream.chance(0.5) ? 1 : -1) * std::pow(10, -1 - 15 * stream.uniform());
    const double beside = radius * (1 + hair) / std::hypot(way.x, way.y);
    const double along = stream.uniform();
    const Disc disc{{from.x + along * way.x - beside * way.y, from.y + along * way.y + beside * way.x},
                    radius};
    const Snapshot snapshot = snapshot_of(robot, goal);
    const LegJudge judge(snapshot, grow(std::vector{disc}, 0, {1e6, 1e6}, touching),
                         {barrier, StepAcross::arc});
    const double expected = plain_penalty(disc, robot, particle, goal, barrier);
    ASSERT_EQ(judge.penalty(particle), expected) << trial;
    (expected > 0 ? crossed : missed) += 1;
  }
  EXPECT_GT(crossed, 5000);
  EXPECT_GT(missed, 5000);
}

TEST(ArcPenalty, AStepAcrossADiscMayBeBarred) {
  const std::vector<Disc> discs = {{{30, 50}, 4}, {{60, 50}, 6}};
  EXPECT_NEAR(penalty(discs, {10, 50}, {40, 50}, {90, 50}, {1000, StepAcross::barred}), 1000 + pi * 6, 1e-9);
}

TEST(ArcPenalty, ARobotThatADiscHasRunIntoMayBeBarredFromGoingDeeper) {
  const std::vector<Disc> discs = {{{30, 50}, 4}};
  const Point robot{27, 50};  // 1 deep
  const LegJudge::Rules arc{1000, StepAcross::arc};
  const LegJudge::Rules barred{1000, StepAcross::barred};
  EXPECT_EQ(penalty(discs, robot, {35, 50}, {35, 90}, barred), 1000);  // through the middle
  EXPECT_EQ(penalty(discs, robot, {35, 50}, {35, 90}, arc), 0);
  EXPECT_EQ(penalty(discs, robot, {22, 50}, {22, 90}, barred), 0);  // straight out
  EXPECT_EQ(penalty(discs, robot, {26.9, 58}, {26.9, 90}, barred), 0);
}

TEST(ArcPenalty, WhatTheRefereeCallsACollisionIsInside) {
  EXPECT_GT(penalty({{{50, 50}, 8}}, {40, 50}, {42 + 1.1e-9, 50}, {42, 90}), 1e5);
  EXPECT_EQ(penalty({{{50, 50}, 8}}, {40, 50}, {42 + 1e-12, 50}, {42, 90}), 0);  // on it, but for rounding
}

TEST(ArcPenalty, AnAdjacentDiscMakesTheLesserArcTheDearerOne) {
  // The line passes below the centre: the arc below is the lesser one, 8 * 2 acos(1/8). A disc of radius 2
  // that touches from below adds 4 pi there, and the arc above becomes the way.
  const double d = 2 * std::acos(1.0 / 8);
  const std::vector<Disc> alone = {{{50, 49}, 8}};
  EXPECT_NEAR(penalty(alone, {10, 50}, {15, 50}, {90, 50}), 8 * d, 1e-9);
  const std::vector<Disc> pair = {{{50, 49}, 8}, {{50, 59}, 2}};
  EXPECT_NEAR(penalty(pair, {10, 50}, {15, 50}, {90, 50}), std::min(8 * d + 4 * pi, 8 * (2 * pi - d)), 1e-9);
  const std::vector<Disc> chain = {{{50, 49}, 8}, {{50, 59}, 2}, {{50, 64}, 3}, {{50, 70}, 3}};
  EXPECT_NEAR(penalty(chain, {10, 50}, {15, 50}, {90, 50}), 8 * (2 * pi - d), 1e-9);
  const std::vector<Disc> both = {{{50, 49}, 8}, {{50, 59}, 2}, {{50, 40}, 1}};
  EXPECT_NEAR(penalty(both, {10, 50}, {15, 50}, {90, 50}),
              std::min(8 * d + 4 * pi, 8 * (2 * pi - d) + 2 * pi), 1e-9);
}

TEST(ArcPenalty, DiscsAreAdjacentWhenTheRobotDoesNotFitBetween) {
  const std::vector<Disc> discs = {{{50, 50}, 5}, {{50, 61.9}, 5}};  // a gap of 1.9
  EXPECT_TRUE(grow(discs, 0.9, {100, 100}, touching)[0].neighbours.empty());
  EXPECT_EQ(grow(discs, 1.0, {100, 100}, touching)[0].neighbours.size(), 1U);
}

TEST(ArcPenalty, ARingOfTouchingDiscsTerminates) {
  // Twelve discs around the robot, each touching two others. Two are cut in half by the line: from either arc
  // of either one, all eleven others hang together.
  std::vector<Disc> ring;
  const double rho = 30 * std::sin(pi / 12);
  for (int k = 0; k < 12; ++k) {
    ring.push_back({{50 + 30 * std::cos(k * pi / 6), 50 + 30 * std::sin(k * pi / 6)}, rho});
  }
  const double through = pi * rho + 11 * 2 * pi * rho;
  EXPECT_NEAR(penalty(ring, {50, 50}, {52, 50}, {95, 50}), through, 1e-6);
  EXPECT_NEAR(penalty(ring, {2, 50}, {5, 50}, {98, 50}), 2 * through, 1e-6);
}

TEST(ArcPenalty, AParticleInsideADiscIsBarredByItsDepth) {
  EXPECT_NEAR(penalty({{{50, 50}, 8}}, {40, 50}, {45, 50}, {90, 50}, {1000, StepAcross::arc}), 1003, 1e-9);
}

TEST(ArcPenalty, AParticleOutsideTheWorkspaceIsBarred) {
  EXPECT_NEAR(penalty({}, {2, 50}, {-3, 50}, {90, 50}, {1000, StepAcross::arc}), 1003, 1e-9);
  EXPECT_NEAR(penalty({}, {2, 50}, {1, 50}, {90, 50}, {1000, StepAcross::arc}, 2), 1001, 1e-9);
}

TEST(ArcPenalty, ADiscAroundTheGoalOrTheRobotDoesNotBlockItsOwnLeg) {
  EXPECT_EQ(penalty({{{88, 50}, 8}}, {10, 50}, {15, 50}, {90, 50}), 0);
  EXPECT_EQ(penalty({{{12, 50}, 4}}, {10, 50}, {18, 50}, {90, 50}), 0);
}

TEST(ArcPenalty, WhereTheRobotDoesNotFitBetweenDiscAndBorderIsNoWay) {
  // Touching the border above: only the way below is left, be it the lesser one or not.
  const double d = 2 * std::acos(1.0 / 8);
  EXPECT_NEAR(penalty({{{50, 8}, 8}}, {10, 9}, {15, 9}, {90, 9}), 8 * d, 1e-9);
  EXPECT_NEAR(penalty({{{50, 8}, 8}}, {10, 7}, {15, 7}, {90, 7}), 8 * (2 * pi - d), 1e-9);
  // A robot of radius 2 fits nowhere past a disc that leaves 3 to each border.
  const std::vector<Disc> plug = {{{100, 50}, 47}};
  const auto across = chord({0, 50}, {200, 50}, {100, 50}, 49);
  ASSERT_TRUE(across.has_value());
  EXPECT_TRUE(std::isinf(way_around(grow(plug, 2, {200, 100}, touching)[0], *across)));
  EXPECT_NEAR(way_around(grow(plug, 1.4, {200, 100}, touching)[0], *across), pi * 48.4, 1e-9);
}

TEST(ArcPenalty, WithoutAnyWayAroundIsTheBarrier) {
  // A disc from border to border: 100 high.
  EXPECT_NEAR(penalty({{{50, 50}, 50}}, {1, 8}, {2, 8}, {99, 8}, {777, StepAcross::arc}), 777, 1e-9);
}

// The recursion of eq. (10), literally: each disc's circumference, then those of its unvisited neighbours.
double circumference(const std::vector<Disc>& discs, std::size_t o, std::vector<bool>& visited) {
  visited[o] = true;
  double sum = 2 * pi * discs[o].radius;
  for (std::size_t s = 0; s < discs.size(); ++s) {
    const double gap =
        std::hypot(discs[s].centre.x - discs[o].centre.x, discs[s].centre.y - discs[o].centre.y) -
        discs[s].radius - discs[o].radius;
    if (!visited[s] && gap <= touching) sum += circumference(discs, s, visited);
  }
  return sum;
}

double recursive_way(const std::vector<Disc>& discs, std::size_t o, const Chord& chord) {
  double least = 1e300;
  for (const bool inside : {true, false}) {
    const double span = std::fmod(chord.exit - chord.entry + 4 * pi, 2 * pi);
    double cost = discs[o].radius * (inside ? span : 2 * pi - span);
    std::vector<bool> visited(discs.size(), false);
    visited[o] = true;
    for (std::size_t s = 0; s < discs.size(); ++s) {
      const double dx = discs[s].centre.x - discs[o].centre.x;
      const double dy = discs[s].centre.y - discs[o].centre.y;
      if (visited[s] || std::hypot(dx, dy) - discs[s].radius - discs[o].radius > touching) continue;
      const bool on_arc = std::fmod(std::atan2(dy, dx) - chord.entry + 4 * pi, 2 * pi) <= span;
      if (on_arc == inside) cost += circumference(discs, s, visited);
    }
    least = std::min(least, cost);
  }
  return least;
}

TEST(ArcPenalty, GroupsOfNeighboursAreTheRecursionUnrolled) {
  int with_neighbours = 0;
  for (std::uint64_t k = 0; k < 300; ++k) {
    Stream stream = Stream(41).fork(k);
    std::vector<Disc> discs;
    for (int d = 0; d < 14; ++d) {
      discs.push_back({{30 + 40 * stream.uniform(), 30 + 40 * stream.uniform()}, 2 + 4 * stream.uniform()});
    }
    const std::vector<Obstacle> obstacles = grow(discs, 0, {100, 100}, touching);
    for (std::size_t o = 0; o < discs.size(); ++o) {
      const Chord across{2 * pi * stream.uniform() - pi, 2 * pi * stream.uniform() - pi};
      EXPECT_NEAR(way_around(obstacles[o], across), recursive_way(discs, o, across), 1e-9) << k << ' ' << o;
      with_neighbours += obstacles[o].neighbours.size() > 1 ? 1 : 0;
    }
  }
  EXPECT_GT(with_neighbours, 1000);
}

}  // namespace
}  // namespace pathrace::algorithms
