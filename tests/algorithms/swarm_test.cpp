// The swarm's equations, its bounds and its memory.
#include "algorithms/pso/swarm.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pathrace::algorithms {
namespace {

SwarmBox box_of(std::size_t dimensions, double reach, double speed) {
  return {std::vector<double>(dimensions, -reach), std::vector<double>(dimensions, reach),
          std::vector<double>(dimensions, speed)};
}

SwarmSettings settings_of(int particles) {
  SwarmSettings settings;
  settings.particles = particles;
  return settings;
}

void put(Swarm& swarm, std::size_t i, double position, double velocity, double cost) {
  std::fill(swarm.position(i).begin(), swarm.position(i).end(), position);
  std::fill(swarm.velocity(i).begin(), swarm.velocity(i).end(), velocity);
  swarm.judge(i, cost);
}

TEST(Inertia, FallsLinearlyFrom095To04) {
  const SwarmSettings settings;
  EXPECT_DOUBLE_EQ(momentum(settings, 0, 50).inertia, 0.95);
  EXPECT_DOUBLE_EQ(momentum(settings, 25, 50).inertia, 0.675);
  EXPECT_DOUBLE_EQ(momentum(settings, 50, 50).inertia, 0.4);
  EXPECT_DOUBLE_EQ(momentum(settings, 60, 50).inertia, 0.4);
  EXPECT_DOUBLE_EQ(momentum(settings, 0, 0).inertia, 0.4);
  EXPECT_DOUBLE_EQ(momentum(settings, 25, 50).scale, 1);
}

TEST(Inertia, MayBeConstantOrGiveWayToAConstriction) {
  SwarmSettings settings;
  settings.inertia = InertiaRule::constant;
  EXPECT_DOUBLE_EQ(momentum(settings, 40, 50).inertia, 0.95);
  settings.inertia = InertiaRule::constriction;
  settings.c1 = settings.c2 = 2.05;
  // Clerc and Kennedy: 2 / |2 - phi - sqrt(phi^2 - 4 phi)|, 0.72984 for phi = 4.1.
  EXPECT_NEAR(momentum(settings, 40, 50).scale, 0.72984, 1e-5);
  EXPECT_DOUBLE_EQ(momentum(settings, 40, 50).inertia, 1);
  settings.c1 = settings.c2 = 1;
  EXPECT_DOUBLE_EQ(momentum(settings, 40, 50).scale, 1);
}

TEST(SwarmMove, WithoutPullsAParticleDriftsByItsInertia) {
  SwarmSettings settings = settings_of(1);
  settings.c1 = settings.c2 = 0;
  Swarm swarm(settings, box_of(3, 100, 10));
  put(swarm, 0, 1, 4, 0);
  swarm.learn(1);
  swarm.move(0, 1, {0.5, 1}, Stream(1));
  EXPECT_EQ(swarm.position(0)[2], 3);
  swarm.move(0, 1, {0.5, 0.5}, Stream(2));
  EXPECT_EQ(swarm.position(0)[2], 3.5);
}

TEST(SwarmMove, FollowsEquationOneWithFreshNumbersPerCoordinate) {
  // More coordinates than a vector has lanes.
  constexpr std::size_t dimensions = 37;
  Swarm swarm(settings_of(2), box_of(dimensions, 1000, 500));
  put(swarm, 0, 10, 0, 5);
  put(swarm, 1, -30, 0, 1);
  swarm.learn(2);
  put(swarm, 0, 20, 3, 9);
  swarm.learn(2);  // particle 0 remembers 10, the swarm -30
  swarm.move(0, 1, {0.7, 1}, Stream(4));
  Stream draws = Stream(4).fork(0);
  for (std::size_t d = 0; d < dimensions; ++d) {
    const std::uint64_t bits = draws.bits();
    const double r1 = std::ldexp(static_cast<double>(bits >> 32), -32);
    const double r2 = std::ldexp(static_cast<double>(bits & 0xFFFFFFFFU), -32);
    EXPECT_DOUBLE_EQ(swarm.velocity(0)[d], 0.7 * 3 + 2 * r1 * (10 - 20) + 2 * r2 * (-30 - 20)) << d;
    EXPECT_DOUBLE_EQ(swarm.position(0)[d], 20 + swarm.velocity(0)[d]) << d;
  }
}

// A swarm of 13 particles on a ring, each somewhere else and with other memories.
Swarm scattered(std::size_t dimensions) {
  SwarmSettings settings = settings_of(13);
  settings.topology = Topology::ring;
  Swarm swarm(settings, box_of(dimensions, 20, 5));
  for (const std::uint64_t round : {0U, 1U}) {
    for (std::size_t i = 0; i < swarm.size(); ++i) {
      Stream stream = Stream(21).fork(round).fork(i);
      for (double& x : swarm.position(i)) x = 40 * stream.uniform() - 20;
      for (double& v : swarm.velocity(i)) v = 10 * stream.uniform() - 5;
      swarm.judge(i, stream.uniform());
    }
    swarm.learn(swarm.size());
  }
  return swarm;
}

TEST(SwarmMove, AbreastEachParticleMovesAsEquationOneSaysAndTheOthersStay) {
  // Around a block of coordinates, and a draw per coordinate from the particle's own stream.
  for (const std::size_t dimensions : {1U, 2U, 15U, 16U, 18U, 37U}) {
    for (const auto& [first, count] : {std::pair{0U, 8U}, {8U, 5U}, {3U, 1U}, {6U, 7U}, {2U, 4U}}) {
      const Swarm before = scattered(dimensions);
      Swarm swarm = before;
      swarm.move(first, count, {0.75, 0.5}, Stream(22));
      for (std::size_t i = 0; i < swarm.size(); ++i) {
        const bool moves = i >= first && i < first + count;
        std::size_t guide = i;
        for (const std::size_t other : {(i + 1) % 13, (i + 12) % 13}) {
          if (before.best_cost(other) < before.best_cost(guide)) guide = other;
        }
        Stream stream = Stream(22).fork(i);
        for (std::size_t d = 0; d < dimensions; ++d) {
          const std::uint64_t bits = stream.bits();
          const double r1 = std::ldexp(static_cast<double>(bits >> 32), -32);
          const double r2 = std::ldexp(static_cast<double>(bits & 0xFFFFFFFFU), -32);
          const double x = before.position(i)[d];
          const double v = Swarm(before).velocity(i)[d];
          const double pulls =
              2 * r1 * (before.best_position(i)[d] - x) + 2 * r2 * (before.best_position(guide)[d] - x);
          const double speed = std::clamp(0.5 * (0.75 * v + pulls), -5.0, 5.0);
          EXPECT_EQ(swarm.velocity(i)[d], moves ? speed : v) << dimensions << ' ' << i << ' ' << d;
          EXPECT_EQ(swarm.position(i)[d], moves ? std::clamp(x + speed, -20.0, 20.0) : x);
        }
      }
    }
  }
}

TEST(SwarmMove, ClipsSpeedAndPlaceAndKeepsTheVelocity) {
  Swarm swarm(settings_of(2), box_of(4, 10, 3));
  put(swarm, 0, 9, 3, 1);
  put(swarm, 1, -9, 3, 2);
  swarm.learn(2);
  swarm.move(0, 1, {1, 1}, Stream(1));
  EXPECT_EQ(swarm.position(0)[0], 10);
  EXPECT_EQ(swarm.velocity(0)[0], 3);
  for (std::uint64_t k = 0; k < 50; ++k) {
    swarm.move(0, 2, {2, 1}, Stream(2).fork(k));
    for (std::size_t i = 0; i < 2; ++i) {
      for (std::size_t d = 0; d < 4; ++d) {
        EXPECT_LE(std::abs(swarm.velocity(i)[d]), 3);
        EXPECT_LE(std::abs(swarm.position(i)[d]), 10);
      }
    }
  }
}

TEST(SwarmMemory, OnlyTheStrictlyBetterReplacesAndOfEqualsTheLowestIndexLeads) {
  Swarm swarm(settings_of(3), box_of(1, 10, 1));
  put(swarm, 0, 1, 0, 7);
  put(swarm, 1, 2, 0, 4);
  put(swarm, 2, 3, 0, 4);
  EXPECT_TRUE(swarm.learn(3));
  EXPECT_EQ(swarm.best_position()[0], 2);
  put(swarm, 0, 4, 0, 4);  // as good as the best, and of a lower index, but later
  put(swarm, 1, 5, 0, 4);
  EXPECT_FALSE(swarm.learn(3));
  EXPECT_EQ(swarm.best_position()[0], 2);
  EXPECT_EQ(swarm.best_position(0)[0], 4);
  EXPECT_EQ(swarm.best_position(1)[0], 2);
}

TEST(SwarmMemory, WhatIsNoNumberOrNotPaidForIsNotLearnt) {
  Swarm swarm(settings_of(3), box_of(1, 10, 1));
  put(swarm, 0, 1, 0, std::numeric_limits<double>::quiet_NaN());
  put(swarm, 1, 2, 0, 4);
  put(swarm, 2, 3, 0, 1);
  EXPECT_TRUE(swarm.learn(2));
  EXPECT_EQ(swarm.best_cost(), 4);
  EXPECT_TRUE(std::isinf(swarm.best_cost(0)));
  swarm.forget();
  EXPECT_FALSE(swarm.learn(3));
  EXPECT_TRUE(std::isinf(swarm.best_cost()));
}

TEST(SwarmTopology, OnARingNewsTravelsOneNeighbourAtATime) {
  SwarmSettings settings = settings_of(9);
  settings.topology = Topology::ring;
  settings.c1 = 0;
  Swarm swarm(settings, box_of(1, 100, 100));
  for (std::size_t i = 0; i < 9; ++i) put(swarm, i, 10, 0, i == 4 ? 1 : 5);
  swarm.position(4)[0] = -50;
  swarm.learn(9);
  swarm.move(0, 8, {1, 1}, Stream(8));
  swarm.move(8, 1, {1, 1}, Stream(8));
  for (std::size_t i = 0; i < 9; ++i) {
    const bool near = i == 3 || i == 5;
    EXPECT_EQ(swarm.position(i)[0] < 10, near || i == 4) << i;
  }
}

TEST(Swarm, FindsTheBottomOfABowl) {
  for (const Topology topology : {Topology::global, Topology::ring}) {
    SwarmSettings settings = settings_of(30);
    settings.topology = topology;
    Swarm swarm(settings, box_of(5, 50, 25));
    for (std::size_t i = 0; i < swarm.size(); ++i) {
      Stream stream = Stream(12).fork(i);
      for (double& x : swarm.position(i)) x = 100 * stream.uniform() - 50;
    }
    for (std::size_t k = 0; k <= 300; ++k) {
      for (std::size_t i = 0; i < swarm.size(); ++i) {
        if (k > 0) swarm.move(i, 1, momentum(settings, k, 300), Stream(13).fork(k));
        double sum = 0;
        for (const double x : swarm.position(i)) sum += (x - 7) * (x - 7);
        swarm.judge(i, sum);
      }
      swarm.learn(swarm.size());
    }
    EXPECT_LT(swarm.best_cost(), 1e-3) << name(topology);
  }
}

}  // namespace
}  // namespace pathrace::algorithms
