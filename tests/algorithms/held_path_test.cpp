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
    expect_same_strengths(held, plain);
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

class HeldOnRows : public ::testing::Test {
 protected:
  HeldOnRows() {
    EXPECT_FALSE(comes(0, east)) << "it comes for the first time";
    EXPECT_TRUE(comes(0, east));
  }

  bool comes(std::size_t from, const std::vector<std::uint8_t>& directions, bool both_ways = false) {
    return path.comes(rows.data(), steps, from, directions, both_ways);
  }
  float strength() const { return rows[0].strength[0]; }

  OccupancyGrid grid = testing::grid_of({"..."});
  MoveTable moves{grid, MoveRule::free};
  RowSteps steps{moves};
  std::vector<TrailRow> rows{moves.size()};
  std::vector<std::uint8_t> east = {0};
  HeldPath path{moves.size()};
};

TEST_F(HeldOnRows, AnotherStartOrOtherDirectionsOrStepsAreAnotherPath) {
  EXPECT_FALSE(comes(1, east));
  EXPECT_FALSE(comes(1, {0, 0}));
  EXPECT_FALSE(comes(1, {0, 0}, true));
  EXPECT_TRUE(comes(1, {0, 0}, true));
}

TEST_F(HeldOnRows, ItsRowsHaveTheSumsOnceItEnds) {
  path.add(2, 1, 100);
  ASSERT_TRUE(comes(0, east));
  path.add(3, 1, 100);
  EXPECT_EQ(strength(), 0);
  path.end();
  EXPECT_EQ(strength(), 6);
  EXPECT_FALSE(comes(0, east)) << "there is no last path any more";
}

TEST_F(HeldOnRows, ItsRowsHaveTheSumsOnceAnotherPathComes) {
  path.add(2, 0.5, 100);
  EXPECT_FALSE(comes(1, east));
  EXPECT_EQ(strength(), 2.5F);
}

TEST_F(HeldOnRows, SumsStayWithinTheLimits) {
  path.add(2, 0, 1.5F);
  path.end();
  EXPECT_EQ(strength(), 1.5F);
}

TEST_F(HeldOnRows, WhatIsDroppedDoesNotComeBack) {
  path.add(2, 0, 100);
  path.drop();
  path.end();
  EXPECT_EQ(strength(), 0);
}

TEST_F(HeldOnRows, APathThatComesToARowTwiceIsNotHeld) {
  for (int time = 0; time < 3; ++time) EXPECT_FALSE(comes(0, {0, 4}));
  EXPECT_FALSE(comes(0, east));
  EXPECT_TRUE(comes(0, east)) << "nothing is left of the other";
}

}  // namespace
}  // namespace pathrace::algorithms
