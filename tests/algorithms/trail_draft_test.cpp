// Drafts of a trail: what is made of them beside the trail is what the trail itself would have become.
#include <gtest/gtest.h>

#include "algorithms/aco/trail.hpp"
#include "core/stream.hpp"
#include "tests/algorithms/trail_field.hpp"

namespace pathrace::algorithms {
namespace {

void change_draft(Trail& trail, std::size_t first, const std::vector<std::uint8_t>& walk, double factor,
                  double amount, bool both_ways) {
  factor == 1 ? trail.deposit_on_draft(first, walk, amount, both_ways)
              : trail.change_draft_along(first, walk, factor, amount, both_ways);
}

// While a draft is under way, other threads read copies of the trail's rows; else the rows themselves.
void expect_copies(const Trail& trail, std::size_t size, bool drafting) {
  const TrailRow* const copies = trail.rows_for_others();
  EXPECT_EQ(copies != trail.rows(), drafting);
  for (std::size_t i = 0; i < size; ++i) {
    ASSERT_EQ(copies[i].strength, trail.rows()[i].strength) << i;
    ASSERT_EQ(copies[i].desirability, trail.rows()[i].desirability) << i;
  }
}

// As often as `evaporate` rewrites the trail, there is no draft to be had.
TEST(TrailDraft, AnAdoptedDraftIsEvaporationAndTheSameChangesBitForBit) {
  const std::vector<std::string> rows(6, ".......");
  for (const bool both_ways : {false, true}) {
    Stream stream(6);
    Field plain(rows, MoveRule::free, 1, 1, equal);
    Field drafted(rows, MoveRule::free, 1, 1, equal);
    for (Field* field : {&plain, &drafted}) field->trail.limit(0.25, 9);
    drafted.trail.keep_draft();
    int refused = 0;
    for (int round = 0; round < 200; ++round) {
      const bool draft = drafted.trail.begin_draft(0.8);
      refused += draft ? 0 : 1;
      if (!draft) drafted.trail.evaporate(0.8);
      plain.trail.evaporate(0.8);
      for (int k = 0; k < 5; ++k) {
        const std::size_t first = plain.at(stream.between(0, 6), stream.between(0, 5));
        const std::vector<std::uint8_t> walk = random_walk(plain.moves, first, stream);
        const double amount = 4 * stream.uniform();
        const double factor = stream.chance(0.3) ? stream.uniform() : 1;
        plain.trail.change_along(first, walk, factor, amount, both_ways);
        draft ? change_draft(drafted.trail, first, walk, factor, amount, both_ways)
              : drafted.trail.change_along(first, walk, factor, amount, both_ways);
      }
      if (draft) drafted.trail.adopt_draft();
      ASSERT_EQ(drafted.trail.least_strength(), plain.trail.least_strength());
      ASSERT_NO_FATAL_FAILURE(expect_same_strengths(drafted, plain)) << round;
    }
    EXPECT_GT(refused, 0);
    EXPECT_LT(refused, 5);
  }
}

// Rows are copied to a draft only where they differ; what else is done to the trail must not be forgotten.
TEST(TrailDraft, ADraftFollowsWhateverElseChangesTheTrail) {
  const std::vector<std::string> rows(6, ".......");
  Stream stream(7);
  Field plain(rows, MoveRule::free, 1, 1, equal);
  Field drafted(rows, MoveRule::free, 1, 1, equal);
  drafted.trail.keep_draft();
  const auto both = [&](const auto& act) {
    for (Field* field : {&plain, &drafted}) act(field->trail);
  };
  const std::size_t end = plain.moves.size();
  std::size_t first = 0;
  std::vector<std::uint8_t> walk;
  for (int round = 0; round < 600; ++round) {
    if (round % 5 < 2) {  // else that of the round before
      first = plain.at(stream.between(0, 6), stream.between(0, 5));
      walk = random_walk(plain.moves, first, stream);
      if (round % 2 == 0) walk.resize(4);  // likely to come to no row twice, so that it is held
    }
    const double amount = 2 * stream.uniform();
    const int deed = round % 8;
    if (deed == 0) both([&](Trail& trail) { trail.change(first, 3, 0.5, amount); });
    if (deed == 1) both([&](Trail& trail) { trail.change_along(first, walk, 0.7, amount, true); });
    if (deed == 2) both([&](Trail& trail) { trail.change_along(first, walk, 1, amount, false); });
    if (deed == 3) both([&](Trail& trail) { trail.limit(0.01 + amount / 100, 5 + amount); });
    if (deed == 4) both([&](Trail& trail) { trail.reset(amount); });
    if (deed == 5) both([&](Trail& trail) { trail.set(first, 5, amount); });
    if (deed == 6) both([&](Trail& trail) { trail.evaporate(0.5); });
    if (deed == 7 && drafted.trail.begin_draft(0.9)) {
      drafted.trail.deposit_on_draft(first, walk, amount, true);  // and is not adopted
    }
    const bool draft = drafted.trail.begin_draft(0.95);
    expect_copies(drafted.trail, end, draft);
    if (!draft) drafted.trail.evaporate(0.95);
    plain.trail.evaporate(0.95);
    for (int ant = 0; ant < 4; ++ant) {
      const double factor = round % 3 == 0 && ant == 2 ? 0.9 : 1;
      plain.trail.change_along(first, walk, factor, amount, true);
      draft ? change_draft(drafted.trail, first, walk, factor, amount, true)
            : drafted.trail.change_along(first, walk, factor, amount, true);
    }
    expect_copies(drafted.trail, end, draft);
    if (draft) drafted.trail.adopt_draft();
    EXPECT_EQ(drafted.trail.rows_for_others(), drafted.trail.rows());
    ASSERT_NO_FATAL_FAILURE(expect_same_strengths(drafted, plain)) << round;
  }
}

// Where a path has been marked already, its rows are not marked again.
TEST(TrailDraft, TheSameDirectionsFromAnotherCellAreAnotherPath) {
  Field plain(open_ground, MoveRule::free, 1, 1, equal);
  Field drafted(open_ground, MoveRule::free, 1, 1, equal);
  const std::vector<std::uint8_t> east = {0, 0};
  drafted.trail.keep_draft();
  for (int round = 0; round < 3; ++round) {
    ASSERT_TRUE(drafted.trail.begin_draft(0.5));
    plain.trail.evaporate(0.5);
    for (const int y : {0, 1, 2, 2}) {
      plain.trail.change_along(plain.at(0, y), east, 1, 1 + y, true);
      drafted.trail.deposit_on_draft(plain.at(0, y), east, 1 + y, true);
    }
    drafted.trail.adopt_draft();
    ASSERT_NO_FATAL_FAILURE(expect_same_strengths(drafted, plain)) << round;
  }
}

TEST(TrailDraft, ADraftThatIsNotAdoptedChangesNothing) {
  Field field(open_ground, MoveRule::free, 1, 1, equal);
  const std::size_t middle = field.at(1, 1);
  field.trail.keep_draft();
  ASSERT_TRUE(field.trail.begin_draft(0.5));
  field.trail.deposit_on_draft(middle, std::vector<std::uint8_t>{0}, 3, true);
  EXPECT_EQ(field.trail.pheromone(middle, 0), 1);
  ASSERT_TRUE(field.trail.begin_draft(0.5));
  field.trail.adopt_draft();
  EXPECT_EQ(field.trail.pheromone(middle, 0), 0.5);
}

TEST(TrailDraft, ThereIsNoDraftWhereStrengthsArePowers) {
  Field field(open_ground, MoveRule::free, 2, 1, equal);
  field.trail.keep_draft();
  EXPECT_FALSE(field.trail.begin_draft(0.5));
}

TEST(TrailDraft, ThereIsNoDraftWhereNoneIsKept) {
  EXPECT_FALSE(Field(open_ground, MoveRule::free, 1, 1, equal).trail.begin_draft(0.5));
}

TEST(TrailDraft, AStepClosedBesideADraftStaysClosed) {
  Field field(open_ground, MoveRule::free, 1, 1, equal);
  const std::size_t middle = field.at(1, 1);
  field.trail.keep_draft();
  ASSERT_TRUE(field.trail.begin_draft(0.5));
  field.trail.close(middle, 4);
  expect_copies(field.trail, field.moves.size(), true);
  field.trail.adopt_draft();
  EXPECT_EQ(field.trail.weight(middle, 4), 0);
  EXPECT_GT(field.trail.weight(middle, 5), 0);
}

}  // namespace
}  // namespace pathrace::algorithms
