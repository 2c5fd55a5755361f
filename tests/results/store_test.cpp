#include "results/store.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/results/rows.hpp"

namespace pathrace::results {
namespace {

TEST(Store, GivesRowsBackBitForBitInOrderOfInsertion) {
  const TemporaryFolder folder;
  const std::vector<TrialRow> rows = strange_rows();
  Store::create(folder / "results.db", some_identity()).append(rows);
  const Store store = Store::open(folder / "results.db", Access::read);
  const std::vector<TrialRow> read = all_rows(store);
  ASSERT_EQ(read.size(), rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) expect_same(rows[i], read[i]);
}

TEST(Store, GivesSlimRowsWithoutPathAndTrace) {
  const TemporaryFolder folder;
  const std::vector<TrialRow> rows = strange_rows();
  Store store = Store::create(folder / "results.db", some_identity());
  store.append(rows);
  std::size_t i = 0;
  store.for_each_slim([&](const TrialRow& row) {
    ASSERT_LT(i, rows.size());
    expect_same_slim(rows[i++], row);
    EXPECT_FALSE(row.answer.has_value());
    EXPECT_TRUE(row.trace.empty());
  });
  EXPECT_EQ(i, rows.size());
}

TEST(Store, RemembersItsCampaign) {
  const TemporaryFolder folder;
  EXPECT_EQ(Store::create(folder / "results.db", some_identity()).identity(), some_identity());
  EXPECT_EQ(Store::open(folder / "results.db", Access::read).identity(), some_identity());
}

TEST(Store, KnowsItsKeysAndDigests) {
  const TemporaryFolder folder;
  Store store = Store::create(folder / "results.db", some_identity());
  EXPECT_EQ(store.size(), 0U);
  EXPECT_TRUE(store.keys().empty());
  const std::vector<TrialRow> rows = strange_rows();
  store.append(rows);
  EXPECT_EQ(store.size(), rows.size());
  const std::vector<KeyedDigest> digests = store.digests();
  ASSERT_EQ(digests.size(), rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_TRUE(store.keys().contains(rows[i].key));
    EXPECT_EQ(digests[i].key, rows[i].key);
    EXPECT_EQ(digests[i].digest, rows[i].digest);
    EXPECT_EQ(digests[i].timed, rows[i].timed);
  }
}

TEST(Store, GoesOnWhereItWasClosed) {
  const TemporaryFolder folder;
  Store::create(folder / "results.db", some_identity()).append({solved_row(1, "a", "trap-u/20/1")});
  Store::open(folder / "results.db", Access::append).append({solved_row(2, "a", "trap-u/20/1")});
  const std::vector<TrialRow> rows = all_rows(Store::open(folder / "results.db", Access::read));
  ASSERT_EQ(rows.size(), 2U);
  expect_same(rows[0], solved_row(1, "a", "trap-u/20/1"));
  expect_same(rows[1], solved_row(2, "a", "trap-u/20/1"));
}

TEST(Store, KeepsScenariosAndReferencesApartByRuleAndTrack) {
  const TemporaryFolder folder;
  Store store = Store::create(folder / "results.db", some_identity());
  std::vector<TrialRow> rows(4, solved_row(0, "a", "trap-u/20/1"));
  rows[1].rule = MoveRule::free;
  rows[1].optimum = 1.5;
  rows[2].track = Track::any_angle;
  rows[2].optimum = 1.9999999999999998;
  rows[3].rule = MoveRule::free;
  rows[3].track = Track::any_angle;
  rows[3].optimum = std::nullopt;
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i].key = i;
  store.append(rows);
  const std::vector<TrialRow> read = all_rows(store);
  ASSERT_EQ(read.size(), rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) expect_same(rows[i], read[i]);
}

TEST(Store, RefusesATrialThatCountsFromAnotherReference) {
  const TemporaryFolder folder;
  const auto counted_from = [](std::uint64_t key, std::optional<double> optimum) {
    TrialRow row = solved_row(key, "a", "trap-u/20/1");
    row.track = Track::any_angle;
    row.optimum = optimum;
    return row;
  };
  Store::create(folder / "results.db", some_identity()).append({counted_from(1, 2.5)});
  Store store = Store::open(folder / "results.db", Access::append);
  const std::vector<std::optional<double>> others = {2.5000000000000004, std::nullopt};
  for (const std::optional<double> other : others) {
    const std::string message = message_of<InputError>([&] {
      store.append({counted_from(2, 2.5), counted_from(3, other)});
    });
    expect_line(message, {"results.db", "'trap-u/20/1'", "any_angle", "2.5"});
    EXPECT_EQ(store.size(), 1U);
  }
  store.append({counted_from(4, 2.5)});
  EXPECT_EQ(store.size(), 2U);
}

TEST(Store, RefusesAKeyTwiceAndKeepsNothingOfThatBatch) {
  const TemporaryFolder folder;
  Store store = Store::create(folder / "results.db", some_identity());
  store.append({solved_row(1, "a", "trap-u/20/1")});
  EXPECT_THROW(store.append({solved_row(2, "b", "trap-l/20/1"), solved_row(1, "b", "trap-l/20/1")}),
               std::logic_error);
  EXPECT_EQ(store.size(), 1U);
  // The names of planner b and its scenario went with the batch and must come back with the next one.
  store.append({solved_row(3, "b", "trap-l/20/1")});
  const std::vector<TrialRow> rows = all_rows(store);
  ASSERT_EQ(rows.size(), 2U);
  expect_same(rows[1], solved_row(3, "b", "trap-l/20/1"));
}

TEST(Store, CannotBeAppendedToWhenOpenedToBeRead) {
  const TemporaryFolder folder;
  Store::create(folder / "results.db", some_identity());
  Store store = Store::open(folder / "results.db", Access::read);
  EXPECT_THROW(store.append({solved_row(1, "a", "trap-u/20/1")}), std::logic_error);
}

TEST(Store, MayBeMoved) {
  const TemporaryFolder folder;
  Store store = Store::create(folder / "a.db", some_identity());
  store = Store::create(folder / "b.db", some_identity());
  Store other = std::move(store);
  other.append({solved_row(1, "a", "trap-u/20/1")});
  EXPECT_EQ(other.size(), 1U);
  EXPECT_EQ(other.file(), folder / "b.db");
  EXPECT_EQ(Store::open(folder / "a.db", Access::append).size(), 0U);
}

TEST(Store, LetsAVisitorsExceptionThrough) {
  const TemporaryFolder folder;
  Store store = Store::create(folder / "results.db", some_identity());
  store.append(strange_rows());
  EXPECT_THROW(store.for_each([](const TrialRow&) { throw std::out_of_range("enough"); }), std::out_of_range);
  EXPECT_EQ(all_rows(store).size(), strange_rows().size());
}

TEST(Store, ShowsAReaderWhatWasThereWhenItBegan) {
  const TemporaryFolder folder;
  Store writer = Store::create(folder / "results.db", some_identity());
  writer.append({solved_row(1, "a", "trap-u/20/1"), solved_row(2, "a", "trap-u/20/1")});
  const Store reader = Store::open(folder / "results.db", Access::read);
  std::size_t seen = 0;
  reader.for_each([&](const TrialRow&) {
    ++seen;
    writer.append({solved_row(100 + seen, "a", "trap-u/20/1")});
  });
  EXPECT_EQ(seen, 2U);
  EXPECT_EQ(reader.size(), 4U);
}

TEST(Store, LeavesOneFileWhenEverybodyIsDone) {
  const TemporaryFolder folder;
  {
    Store writer = Store::create(folder / "results.db", some_identity());
    writer.append({solved_row(1, "a", "trap-u/20/1")});
  }
  EXPECT_EQ(Store::open(folder / "results.db", Access::read).size(), 1U);
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
    EXPECT_EQ(entry.path().filename(), "results.db");
    ++files;
  }
  EXPECT_EQ(files, 1U);
}

TEST(Store, SumsUpHowTrialsEnded) {
  const TemporaryFolder folder;
  Store store = Store::create(folder / "results.db", some_identity());
  EXPECT_TRUE(store.outcomes().empty());
  TrialRow noted = failed_row(4, "b", "y");
  noted.verdict = Verdict::gave_up;
  TrialRow doubtful = noted;
  doubtful.key = 5;
  doubtful.note = "why";
  store.append({solved_row(1, "b", "x"), solved_row(2, "b", "y"), failed_row(3, "a", "x"), noted, doubtful});
  EXPECT_EQ(store.outcomes(), (std::vector<OutcomeCount>{{"a", Verdict::budget, false, 1},
                                                         {"b", Verdict::gave_up, false, 1},
                                                         {"b", Verdict::gave_up, true, 1},
                                                         {"b", Verdict::solved, false, 2}}));
}

}  // namespace
}  // namespace pathrace::results
