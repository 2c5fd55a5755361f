// What a store says when its rows were changed or removed behind its back, and how it reads older versions.

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>

#include <fstream>

#include "results/altered_store.hpp"
#include "results/store.hpp"
#include "tests/results/rows.hpp"

namespace pathrace::results {
namespace {

namespace fs = std::filesystem;

void run_sql(const fs::path& file, const std::string& sql) {
  SQLite::Database(file, SQLite::OPEN_READWRITE).exec(sql);
}

std::string read_file(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

fs::path stored(const TemporaryFolder& folder, const std::vector<TrialRow>& rows) {
  fs::path file = folder / "results.db";
  Store::create(file, some_identity()).append(rows);
  return file;
}

std::vector<TrialRow> three_rows() {
  return {solved_row(1, "a", "trap-u/20/1"), solved_row(2, "b", "trap-u/20/1"),
          solved_row(3, "a", "trap-l/20/1")};
}

// Each statement leaves row 2 of three readable, but not as it was recorded.
TEST(StoreAltered, NamesARowThatWasChanged) {
  const std::vector<std::pair<std::string, std::uint64_t>> changes = {
      {"UPDATE trial SET key = '0123456789abcdef' WHERE number = 2", 0x0123456789ABCDEF},
      {"UPDATE trial SET verdict = 'budget' WHERE number = 2", 2},
      {"UPDATE trial SET length = 1.5 WHERE number = 2", 2},
      {"UPDATE trial SET gap = NULL WHERE number = 2", 2},
      {"UPDATE trial SET turns = 1 WHERE number = 2", 2},
      {"UPDATE trial SET evaluations = 2 WHERE number = 2", 2},
      {"UPDATE trial SET digest = '0000000000000001' WHERE number = 2", 2},
      {"UPDATE trial SET timed = 1 WHERE number = 2", 2},
      {"UPDATE trial SET repetition = 5 WHERE number = 2", 2},
      {"UPDATE trial SET wall_s = 0.0001 WHERE number = 2", 2},
      {"UPDATE trial SET user_s = 0.0001 WHERE number = 2", 2},
      {"UPDATE trial SET crowded = 1 WHERE number = 2", 2},
      {"UPDATE trial SET session = 1 WHERE number = 2", 2},
      {"UPDATE trial SET checksum = '0000000000000001' WHERE number = 2", 2},
      {"UPDATE trial SET planner = 1 WHERE number = 2", 2},
      {"UPDATE trial SET scenario = 2 WHERE number = 2", 2},
      {"UPDATE planner SET label = 'c' WHERE label = 'b'", 2},
      {"UPDATE planner SET draws = 1 WHERE label = 'b'", 2},
  };
  for (const auto& [sql, key] : changes) {
    SCOPED_TRACE(sql);
    const TemporaryFolder folder;
    const fs::path file = stored(folder, three_rows());
    run_sql(file, sql);
    const Store store = Store::open(file, Access::read);
    expect_line(message_of<AlteredStore>([&] { store.for_each_slim([](const TrialRow&) {}); }),
                {file.string(), hex(key), "changed"});
    expect_line(message_of<AlteredStore>([&] { all_rows(store); }), {file.string(), hex(key), "changed"});
    expect_line(message_of<AlteredStore>([&] { store.digests(); }), {file.string(), hex(key), "changed"});
    expect_line(message_of<AlteredStore>([&] { store.keys(); }), {file.string(), hex(key), "changed"});
  }
}

TEST(StoreAltered, NamesARowWhoseAnswerWasChanged) {
  for (const std::string change : {"path = '0,0 1,1 2,0'", "trace = '1,0,3,0.0007,1'", "counters = 'pops=1'",
                                   "path_track = 'any_angle'", "checksum = '0000000000000001'"}) {
    SCOPED_TRACE(change);
    const TemporaryFolder folder;
    const fs::path file = stored(folder, three_rows());
    run_sql(file, "UPDATE answer SET " + change + " WHERE trial = 2");
    const Store store = Store::open(file, Access::read);
    expect_line(message_of<AlteredStore>([&] { all_rows(store); }), {file.string(), hex(2), "changed"});
  }
}

TEST(StoreAltered, MissesRowsThatWereRemovedOrAdded) {
  const TemporaryFolder folder;
  const fs::path file = stored(folder, three_rows());
  run_sql(file, "DELETE FROM trial WHERE number = 3");
  for (const Access access : {Access::read, Access::append}) {
    expect_line(message_of<AlteredStore>([&] { Store::open(file, access); }),
                {file.string(), "2 trials", "3 were recorded"});
  }
}

TEST(StoreAltered, AcceptsRowsOfTwoWritersAndABatchThatWasRefused) {
  const TemporaryFolder folder;
  const fs::path file = stored(folder, three_rows());
  {
    Store store = Store::open(file, Access::append);
    store.append({solved_row(4, "c", "trap-u/20/1")});
    EXPECT_THROW(store.append({solved_row(5, "c", "trap-u/20/1"), solved_row(4, "c", "trap-u/20/1")}),
                 std::logic_error);
  }
  EXPECT_EQ(all_rows(Store::open(file, Access::read)).size(), 4U);
}

// --- older versions ------------------------------------------------------------------------------------

// Takes away what version 6 added.
fs::path stored_as_version_5(const TemporaryFolder& folder, const std::vector<TrialRow>& rows) {
  const fs::path file = stored(folder, rows);
  run_sql(file,
          "DROP VIEW trials; DROP TABLE machine; DELETE FROM meta WHERE name = 'recorded';"
          "ALTER TABLE planner DROP COLUMN draws; ALTER TABLE answer DROP COLUMN checksum;"
          "ALTER TABLE trial DROP COLUMN checksum; ALTER TABLE trial DROP COLUMN session;"
          "ALTER TABLE trial DROP COLUMN user_s; ALTER TABLE trial DROP COLUMN system_s;"
          "CREATE VIEW trials AS SELECT key FROM trial; PRAGMA user_version = 5");
  return file;
}

// Rows that have nothing in the columns that version 6 added.
std::vector<TrialRow> version_5_rows() {
  std::vector<TrialRow> rows = strange_rows();
  for (TrialRow& row : rows) {
    row.costs.user_s = row.costs.system_s = std::nullopt;
    row.session = 0;
    row.draws = std::nullopt;
  }
  return rows;
}

void expect_rows(const Store& store, const std::vector<TrialRow>& rows) {
  const std::vector<TrialRow> read = all_rows(store);
  ASSERT_EQ(read.size(), rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) expect_same(rows[i], read[i]);
}

TEST(StoreMigration, ReadsAStoreOfVersion5AsItIs) {
  const TemporaryFolder folder;
  const fs::path file = stored_as_version_5(folder, version_5_rows());
  const std::string before = read_file(file);
  {
    const Store store = Store::open(file, Access::read);
    EXPECT_EQ(store.identity(), some_identity());
    EXPECT_EQ(store.size(), version_5_rows().size());
    expect_rows(store, version_5_rows());
  }
  EXPECT_EQ(read_file(file), before);
}

TEST(StoreMigration, GoesOnWithAStoreOfVersion5AsOneOfVersion6) {
  const TemporaryFolder folder;
  const fs::path file = stored_as_version_5(folder, version_5_rows());
  std::vector<TrialRow> rows = version_5_rows();
  rows.push_back(solved_row(77, "new", "trap-u/20/1"));
  Store::open(file, Access::append).append({rows.back()});
  expect_rows(Store::open(file, Access::read), rows);
  run_sql(file, "UPDATE trial SET timed = 1 - timed WHERE number = 1");
  EXPECT_THROW(all_rows(Store::open(file, Access::read)), AlteredStore);
}

TEST(StoreMigration, LeavesAStoreOfVersion5AloneWhoseRowsAreDamaged) {
  const TemporaryFolder folder;
  const fs::path file = stored_as_version_5(folder, three_rows());
  run_sql(file, "UPDATE trial SET length = 'long' WHERE number = 2");
  expect_line(message_of<InputError>([&] { Store::open(file, Access::append); }),
              {file.string(), "version 5", "'length'"});
  EXPECT_EQ(Store::open(file, Access::read).size(), 3U);
}

// --- machines ------------------------------------------------------------------------------------------

TEST(StoreMachine, KeepsTheFactsOfEachSession) {
  const TemporaryFolder folder;
  const fs::path file = folder / "results.db";
  const std::vector<MachineFact> first = {{"compiler", "g++ 12"}, {"processor", "one, \"two\""}};
  const std::vector<MachineFact> second = {{"compiler", "clang++ 14"}};
  EXPECT_EQ(Store::create(file, some_identity()).begin_session(first), 1);
  EXPECT_EQ(Store::open(file, Access::append).begin_session(second), 2);
  std::vector<std::pair<int, MachineFact>> facts;
  Store::open(file, Access::read).for_each_fact([&facts](int session, const MachineFact& fact) {
    facts.emplace_back(session, fact);
  });
  const std::vector<std::pair<int, MachineFact>> expected = {{1, first[0]}, {1, first[1]}, {2, second[0]}};
  EXPECT_EQ(facts, expected);
}

}  // namespace
}  // namespace pathrace::results
