// A path that is deposited on again and again is held apart meanwhile, and comes back as if it had not been.
#include "algorithms/aco/held_path.hpp"

#include <gtest/gtest.h>

#include "algorithms/aco/trail.hpp"
#include "core/stream.hpp"
#include "tests/algorithms/trail_field.hpp"

namespace pathrace::algorithms {
namespace {

const std::vector<std::string> hall(8, std::string(8, '.'));
const std::vector<std::uint8_t> zigzag = {0, 1, 2, 1, 0, 7, 0, 1};
const std::vector<std::uint8_t> diagonal = {1, 1, 1, 1};
const std::vector<std::vector<std::uint8_t>> paths = {
    zigzag, diagonal, {0, 2, 4, 6, 1}};  // the last one is a loop

void expect_equal(const Trail& trail, const Trail& expected, const MoveTable& moves) {
  for (std::size_t i = 0; i < moves.size(); ++i) {
    if (moves[i] == 0) continue;
    for (int d = 0; d < direction_count; ++d) {
      if ((moves[i] >> d & 1) == 0) continue;
      ASSERT_EQ(trail.pheromone(i, d), expected.pheromone(i, d)) << i << ' ' << d;
    }
  }
}

// Runs of one path, of others between them, and of one that crosses itself; of amounts that differ.
TEST(HeldPath, DepositsInTurnAreChangesInTurnBitForBit) {
  Stream stream(11);
  for (const double alpha : {1.0, 2.0}) {
    Field plain(hall, MoveRule::free, alpha, 1, equal);
    Field held(hall, MoveRule::free, alpha, 1, equal);
    for (Field* field : {&plain, &held}) field->trail.limit(0.3, 40);
    for (int round = 0; round < 60; ++round) {
      for (Field* field : {&plain, &held}) field->trail.evaporate(0.7);
      Trail::Deposits deposits(held.trail);
      for (int run = 0; run < 5; ++run) {
        const std::vector<std::uint8_t>& path = paths[static_cast<std::size_t>(stream.between(0, 2))];
        const std::size_t from = plain.at(stream.between(0, 1), stream.between(1, 2));
        const bool both_ways = stream.uniform() < 0.5;
        for (int ant = stream.between(1, 4); ant > 0; --ant) {
          const double amount = 3 * stream.uniform();
          plain.trail.change_along(from, path, 1, amount, both_ways);
          deposits.add(from, path, amount, both_ways);
        }
      }
    }
    expect_equal(held.trail, plain.trail, plain.moves);
  }
}

// Neither the next draft nor the trail itself gets what ants brought to a draft that was not adopted.
TEST(HeldPath, OfADraftThatIsNotAdoptedIsForgotten) {
  Field field(hall, MoveRule::free, 1, 1, equal);
  const std::size_t from = field.at(1, 1);
  field.trail.keep_draft();
  const auto deposit_on_draft = [&] {
    ASSERT_TRUE(field.trail.begin_draft(1));
    for (int ant = 0; ant < 2; ++ant) field.trail.deposit_on_draft(from, diagonal, 1, true);
  };
  deposit_on_draft();
  deposit_on_draft();
  field.trail.adopt_draft();
  EXPECT_EQ(field.trail.pheromone(from, 1), 3);
  deposit_on_draft();
  {
    Trail::Deposits deposits(field.trail);
    for (int ant = 0; ant < 2; ++ant) deposits.add(from, diagonal, 1, true);
  }
  EXPECT_EQ(field.trail.pheromone(from, 1), 5);
}

TEST(HeldPath, IsKnownByItsStartItsDirectionsAndItsSteps) {
  HeldPath path(9);
  EXPECT_FALSE(path.is(0, {}, false));
  path.change_to(3, diagonal, true);
  EXPECT_TRUE(path.is(3, diagonal, true));
  EXPECT_FALSE(path.is(4, diagonal, true));
  EXPECT_FALSE(path.is(3, diagonal, false));
  EXPECT_FALSE(path.is(3, zigzag, true));
  path.end();
  EXPECT_FALSE(path.is(3, diagonal, true));
}

class HeldOnRows : public ::testing::Test {
 protected:
  HeldOnRows() { path.change_to(0, east, false); }

  float strength() const { return rows[0].strength[0]; }

  OccupancyGrid grid = testing::grid_of({"..."});
  MoveTable moves{grid, MoveRule::free};
  RowSteps steps{moves};
  std::vector<TrailRow> rows{moves.size()};
  std::vector<std::uint8_t> east = {0};
  HeldPath path{moves.size()};
};

TEST_F(HeldOnRows, ItsRowsHaveTheSumsOnceItEnds) {
  rows[0].strength[0] = 1;
  ASSERT_TRUE(path.hold(rows.data(), steps));
  path.add(2, 0, 100);
  ASSERT_TRUE(path.hold(rows.data(), steps)) << "it is held already";
  path.add(3, 0, 100);
  path.end();
  EXPECT_EQ(strength(), 6);
}

TEST_F(HeldOnRows, ItsRowsHaveTheSumsOnceAnotherPathComes) {
  ASSERT_TRUE(path.hold(rows.data(), steps));
  path.add(2, 0.5, 100);
  path.change_to(1, east, false);
  EXPECT_EQ(strength(), 2.5F);
}

TEST_F(HeldOnRows, SumsStayWithinTheLimits) {
  ASSERT_TRUE(path.hold(rows.data(), steps));
  path.add(2, 0, 1.5F);
  path.end();
  EXPECT_EQ(strength(), 1.5F);
}

TEST_F(HeldOnRows, WhatIsDroppedDoesNotComeBack) {
  ASSERT_TRUE(path.hold(rows.data(), steps));
  path.add(2, 0, 100);
  path.drop();
  path.end();
  EXPECT_EQ(strength(), 0);
}

TEST_F(HeldOnRows, APathThatComesToARowTwiceIsNotHeld) {
  path.change_to(0, std::vector<std::uint8_t>{0, 4}, false);
  EXPECT_FALSE(path.hold(rows.data(), steps));
  path.change_to(0, east, false);
  EXPECT_TRUE(path.hold(rows.data(), steps)) << "nothing is left of the other";
}

}  // namespace
}  // namespace pathrace::algorithms
