// Walkers: what ants do on a trail.
#include "algorithms/aco/walker.hpp"

#include <gtest/gtest.h>

#include "tests/algorithms/walk_field.hpp"
#include "tests/support/maps.hpp"
#include "tests/support/walks.hpp"

namespace pathrace::algorithms {
namespace {

using pathrace::testing::grid_of;

struct PlainRule final : PheromoneRule {
  using PheromoneRule::PheromoneRule;
  double initial_pheromone(const Scout& /*scout*/) const override { return 1; }
  void learn(Colony& /*colony*/, const Harvest& /*harvest*/) override {}
};

TEST(Walker, NeverStepsOnACellTwiceAndArrivesWithItsExactLength) {
  const WalkField field(grid_of({".....", ".....", ".....", ".....", "....."}), MoveRule::strict, {0, 0},
                        {4, 4});
  int arrived = 0;
  for (const Walk& walk : field.walk(DeadEnd::die, 300, 43)) {
    field.expect_simple_and_legal(walk);
    EXPECT_EQ(walk.pops, 0U);
    if (!walk.arrived) continue;
    ++arrived;
    EXPECT_EQ(walk.decisions, walk.directions.size());
  }
  EXPECT_GT(arrived, 0);
}

TEST(Walker, CountsTurnsWhereItIsAskedTo) {
  const WalkField field(grid_of({"....", "....", "....", "...."}), MoveRule::strict, {0, 0}, {3, 3});
  for (const bool asked : {false, true}) {
    Ground ground = field.ground(DeadEnd::backtrack);
    ground.count_turns = asked;
    std::vector<Walk> walks(20);
    AntQueue queue(0, walks.size());
    const Stream stream(17);
    const Meter meter({});
    Walker(ground, 4).run(queue, {stream, no_limit, meter, walks});
    for (const Walk& walk : walks) EXPECT_EQ(walk.turns, asked ? turns_of(walk.directions) : 0);
  }
}

TEST(Walker, EveryAntThatIsBackSigns) {
  const WalkField field(grid_of({"...", "..."}), MoveRule::strict, {0, 0}, {2, 1});
  const Ground ground = field.ground(DeadEnd::die);
  std::vector<Walk> walks(5);
  AntQueue queue(1, 5);
  const Stream stream(1);
  const Meter meter({});
  RollCall roll_call(5, 1);
  Walker(ground, 2).run(queue, {stream, no_limit, meter, walks, 9, &roll_call});
  EXPECT_FALSE(roll_call.has(0, 9));
  for (std::size_t k = 1; k < walks.size(); ++k) EXPECT_TRUE(roll_call.has(k, 9)) << k;
}

// A walk is written only where it differs from the one before in its slot; whatever that was, the new one is
// all there.
TEST(Walker, WhatAWalkWasBeforeDoesNotShow) {
  const WalkField field(grid_of({"....", ".#..", "...#", "...."}), MoveRule::free, {0, 0}, {3, 3});
  for (const DeadEnd dead_end : {DeadEnd::die, DeadEnd::backtrack, DeadEnd::revisit_with_loop_erasure}) {
    Ground ground = field.ground(dead_end);
    ground.keep_popped = ground.count_turns = true;
    Walker walker(ground, 3);
    const Meter meter({});
    std::vector<Walk> again(20);
    for (const std::uint64_t seed : {1U, 1U, 2U, 3U, 3U}) {
      const Stream stream(seed);
      const Outing outing{stream, no_limit, meter, again, 1};
      AntQueue queue(0, again.size());
      walker.run(queue, outing);
      std::vector<Walk> fresh(again.size());
      AntQueue other_queue(0, fresh.size());
      Walker(ground, 3).run(other_queue, {stream, no_limit, meter, fresh, 1});
      EXPECT_EQ(again, fresh) << seed;
      // Somebody changes a few of them.
      for (std::size_t k = 0; k < again.size(); k += 3) again[k].directions = {0, 0, 2};
    }
  }
}

// A draft's copies and the trail differ only in where they are; here they are made to differ in what they
// say.
TEST(Walker, ReadsTheCopiesForOthersUnlessItDeposits) {
  const OccupancyGrid map = grid_of({"...", "...", "..."});
  WalkField field(map, MoveRule::four, {0, 0}, {2, 2});
  const auto prefer = [&](int direction, double pheromone) {
    for (int y = 0; y < 3; ++y) {
      for (int x = 0; x < 3; ++x) {
        const std::size_t index = map.index({x, y});
        if ((field.nest.open(index) >> direction & 1) != 0) field.trail.set(index, direction, pheromone);
      }
    }
  };
  constexpr int east = 0;
  const ColonySettings settings;
  const PlainRule rule(settings);
  std::vector<Walk> walks(1);
  const RollCall roll_call(1, 1);
  EarlyDeposits deposits(rule, field.nest, field.trail, walks, roll_call);
  prefer(east, 1e9);
  ASSERT_TRUE(field.trail.begin_draft(0.5));
  prefer(east, 1e-9);
  const Ground shared = field.ground(DeadEnd::die);
  const Stream stream(3);
  const Meter meter({});
  const auto first_step = [&](EarlyDeposits* early) {
    AntQueue queue(0, 1);
    Walker(shared, 1).run(queue, {stream, no_limit, meter, walks}, early);
    return int{walks[0].directions.front()};
  };
  EXPECT_EQ(first_step(nullptr), east);
  EXPECT_NE(first_step(&deposits), east);
}

// However many lanes and ants there are, and although deposits wait until a few ants are back.
TEST(Walker, WhenItsLastAntIsBackSoAreAllDeposits) {
  WalkField field(grid_of({"...", "...", "..."}), MoveRule::four, {0, 0}, {2, 2});
  const ColonySettings settings;
  const PlainRule rule(settings);
  const Ground ground = field.ground(DeadEnd::backtrack);
  const Stream stream(3);
  const Meter meter({});
  for (std::size_t ants = 1; ants <= 9; ++ants) {
    std::vector<Walk> walks(ants);
    RollCall roll_call(ants, 1);
    EarlyDeposits deposits(rule, field.nest, field.trail, walks, roll_call);
    deposits.begin(ants, 1);
    AntQueue queue(0, ants);
    Walker(ground, 4).run(queue, {stream, no_limit, meter, walks, 1, &roll_call}, &deposits);
    EXPECT_EQ(deposits.tally().walks, ants);
  }
}

TEST(Walker, TheDeadLeaveNoPathUnlessTheyAreAskedTo) {
  const WalkField field(grid_of({"....", ".#..", "...#", "...."}), MoveRule::strict, {0, 0}, {3, 3});
  for (const bool asked : {true, false}) {
    Ground ground = field.ground(DeadEnd::die);
    ground.keep_the_dead = asked;
    std::vector<Walk> walks(40);
    AntQueue queue(0, walks.size());
    const Stream stream(3);
    const Meter meter({});
    Walker(ground, 4).run(queue, {stream, no_limit, meter, walks});
    std::size_t dead = 0;
    for (const Walk& walk : walks) {
      if (walk.arrived) continue;
      ++dead;
      EXPECT_EQ(walk.directions.empty(), !asked);
      EXPECT_EQ(walk.length, length_of(walk.directions));
    }
    EXPECT_GT(dead, 0U);
  }
}

TEST(Walker, StopsAtTheStepLimit) {
  const WalkField field(grid_of({"..................."}), MoveRule::four, {0, 0}, {18, 0});
  const Walk walk = field.walk(DeadEnd::die, 1, 1, 7)[0];
  EXPECT_FALSE(walk.arrived);
  EXPECT_EQ(walk.decisions, 7U);
}

// One alone finds its way by other instructions than several; so does who keeps no list of what it took back.
TEST(Walker, GivesTheSameWalksHoweverManyWalkSideBySide) {
  for (const int side : {20, 70}) {
    const std::size_t ants = side == 20 ? 150 : 30;
    WalkField field(testing::random_grid(Stream(67), side, side, 0.25), MoveRule::strict, {0, 0},
                    {side - 1, side - 1});
    field.let_every_step_weigh();
    for (const DeadEnd dead_end : {DeadEnd::die, DeadEnd::backtrack, DeadEnd::revisit_with_loop_erasure}) {
      for (const double q0 : {0.0, 0.5}) {
        for (const bool keep_popped : {false, true}) {
          Ground ground = field.ground(dead_end);
          ground.q0 = q0;
          ground.keep_popped = keep_popped;
          const std::vector<Walk> expected = WalkField::walk_on(ground, ants, 61, 3000, 1);
          for (const std::size_t lanes : {2U, 3U, 4U, 8U}) {
            EXPECT_EQ(WalkField::walk_on(ground, ants, 61, 3000, lanes), expected)
                << name(dead_end) << ' ' << side << ' ' << q0 << ' ' << keep_popped << ' ' << lanes;
          }
        }
      }
    }
  }
}

TEST(Nest, AClosedCellIsNoObstacleForTheCornerRule) {
  const WalkField open(grid_of({"..", ".."}), MoveRule::strict, {0, 0}, {1, 1});
  Nest nest = open.nest;
  nest.close(open.grid.index({1, 0}));
  EXPECT_EQ(nest.open(nest.start()), 1U << 1 | 1U << 2);  // SE past it, and S
  nest.close(nest.goal());
  EXPECT_FALSE(nest.closed(nest.goal()));
}

TEST(Walk, HasCellsALengthAndTurns) {
  const WalkField field(grid_of({"....", "...."}), MoveRule::strict, {0, 0}, {3, 1});
  Walk walk;
  walk.directions = {0, 1, 0};
  EXPECT_EQ(length_of(walk.directions), (LatticeLength{2, 1}));
  EXPECT_EQ(turns_of(walk.directions), 2);
  EXPECT_EQ(testing::cells_over(field.nest, walk), (std::vector<Cell>{{0, 0}, {1, 0}, {2, 1}, {3, 1}}));
}

}  // namespace
}  // namespace pathrace::algorithms
