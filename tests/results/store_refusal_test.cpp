// What a store refuses: wrong files, damaged files, files that the machine does not let it read or write.

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <fstream>

#include "core/error.hpp"
#include "results/store.hpp"
#include "tests/results/rows.hpp"

namespace pathrace::results {
namespace {

namespace fs = std::filesystem;

void write_file(const fs::path& file, const std::string& content) {
  std::ofstream(file, std::ios::binary) << content;
}

std::string read_file(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void run_sql(const fs::path& file, const std::string& sql) {
  SQLite::Database(file, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE).exec(sql);
}

/// A store of some rows, closed.
fs::path stored(const TemporaryFolder& folder, std::size_t rows = 3) {
  fs::path file = folder / "results.db";
  Store store = Store::create(file, some_identity());
  std::vector<TrialRow> batch;
  for (std::size_t i = 0; i < rows; ++i) batch.push_back(solved_row(i + 1, "a", "trap-u/20/1"));
  store.append(batch);
  return file;
}

void expect_refused(const fs::path& file, const std::vector<std::string>& pieces) {
  for (const Access access : {Access::read, Access::append}) {
    const std::string message = message_of<InputError>([&] { Store::open(file, access); });
    expect_line(message, pieces);
    expect_line(message, {file.string()});
  }
}

/// An ordinary user while it lives: root may write everywhere.
class OrdinaryUser {
 public:
  OrdinaryUser() : root_(::geteuid() == 0) {
    if (root_ && ::seteuid(65534) != 0) throw std::runtime_error("cannot become another user");
  }
  OrdinaryUser(const OrdinaryUser&) = delete;
  OrdinaryUser& operator=(const OrdinaryUser&) = delete;
  ~OrdinaryUser() {
    if (root_ && ::seteuid(0) != 0) std::abort();
  }

 private:
  bool root_;
};

TEST(StoreCreate, RefusesAFileThatExists) {
  const TemporaryFolder folder;
  write_file(folder / "results.db", "precious");
  expect_line(message_of<InputError>([&] { Store::create(folder / "results.db", some_identity()); }),
              {(folder / "results.db").string(), "exists"});
  EXPECT_EQ(read_file(folder / "results.db"), "precious");
}

TEST(StoreCreate, NeedsAFolder) {
  const TemporaryFolder folder;
  expect_line(message_of<EnvironmentError>([&] { Store::create(folder / "no/results.db", some_identity()); }),
              {(folder / "no/results.db").string(), "cannot be written"});
}

TEST(StoreCreate, NeedsPermissionToWrite) {
  const TemporaryFolder folder;
  fs::permissions(folder.path(), fs::perms(0555));
  const OrdinaryUser user;
  expect_line(message_of<EnvironmentError>([&] { Store::create(folder / "results.db", some_identity()); }),
              {(folder / "results.db").string(), "Permission denied"});
}

TEST(StoreOpen, RefusesAMissingFile) {
  const TemporaryFolder folder;
  expect_refused(folder / "results.db", {"no such file"});
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(StoreOpen, RefusesAFolder) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "results.db");
  expect_refused(folder / "results.db", {"not a file"});
}

TEST(StoreOpen, RefusesAnEmptyFile) {
  const TemporaryFolder folder;
  write_file(folder / "results.db", "");
  expect_refused(folder / "results.db", {"empty"});
}

TEST(StoreOpen, RefusesAFileThatIsNotSQLite) {
  const TemporaryFolder folder;
  for (const std::string& content :
       {std::string("x"), std::string("type octile\nheight 4\n"), std::string(5000, '\0'),
        std::string("SQLite format 3") + '\0' + std::string(4000, 'z')}) {
    write_file(folder / "results.db", content);
    expect_refused(folder / "results.db", {"not an SQLite database"});
    EXPECT_EQ(read_file(folder / "results.db"), content);
  }
}

TEST(StoreOpen, RefusesADatabaseOfAnotherProgram) {
  const TemporaryFolder folder;
  run_sql(folder / "results.db", "CREATE TABLE trials (key TEXT); PRAGMA user_version = 1");
  expect_refused(folder / "results.db", {"not a pathrace store", "0x0", "0x70617468"});
}

TEST(StoreOpen, RefusesAnotherSchemaVersionAndNamesBoth) {
  const TemporaryFolder folder;
  const fs::path file = stored(folder);
  run_sql(file, "PRAGMA user_version = 7");
  expect_refused(file, {"schema version 7", "expects version 6"});
}

TEST(StoreOpen, RefusesATruncatedFile) {
  const TemporaryFolder folder;
  const fs::path file = stored(folder, 300);
  fs::resize_file(file, fs::file_size(file) / 2);
  expect_refused(file, {"damaged"});
}

TEST(StoreOpen, RefusesAStoreWithoutItsTablesOrItsCampaign) {
  const TemporaryFolder folder;
  const fs::path file = stored(folder);
  run_sql(file, "UPDATE meta SET value = 'many' WHERE name = 'trials'");
  expect_refused(file, {"damaged", "'trials'", "'many'"});
  run_sql(file, "DELETE FROM meta WHERE name = 'trials'");
  expect_refused(file, {"damaged", "'trials'"});
  run_sql(file, "DROP TABLE meta");
  expect_refused(file, {"damaged", "meta"});
}

TEST(StoreOpen, RefusesASecondWriterButNoReader) {
  const TemporaryFolder folder;
  const Store first = Store::create(folder / "results.db", some_identity());
  expect_line(message_of<InputError>([&] { Store::open(folder / "results.db", Access::append); }),
              {(folder / "results.db").string(), "another run"});
  EXPECT_EQ(Store::open(folder / "results.db", Access::read).size(), 0U);
}

TEST(StoreOpen, NeedsPermission) {
  const TemporaryFolder folder;
  const fs::path file = stored(folder);
  fs::permissions(folder.path(), fs::perms(0755));
  fs::permissions(file, fs::perms(0444));
  const auto append = [&] { Store::open(file, Access::append); };
  const auto read = [&] { Store::open(file, Access::read); };
  {
    const OrdinaryUser user;
    expect_line(message_of<EnvironmentError>(append), {file.string(), "Permission denied"});
  }
  fs::permissions(file, fs::perms(0));
  const OrdinaryUser user;
  expect_line(message_of<EnvironmentError>(read), {file.string(), "Permission denied"});
}

TEST(StoreOpen, ReadsInAFolderThatCannotBeWritten) {
  const TemporaryFolder folder;
  const fs::path strange = folder / "100% #1?&";
  fs::create_directory(strange);
  fs::rename(stored(folder), strange / "results.db");
  fs::permissions(strange / "results.db", fs::perms(0444));
  fs::permissions(strange, fs::perms(0555));
  fs::permissions(folder.path(), fs::perms(0755));
  {
    const OrdinaryUser user;
    EXPECT_EQ(all_rows(Store::open(strange / "results.db", Access::read)).size(), 3U);
  }
  fs::permissions(strange, fs::perms(0755));
}

TEST(StoreAppend, SaysThatTheDiskIsFullAndLosesNothing) {
  const TemporaryFolder folder;
  const fs::path file = stored(folder);
  Store store = Store::open(file, Access::append);
  TrialRow large = solved_row(1000, "a", "trap-u/20/1");
  large.note = std::string(std::size_t{4} << 20, 'x');

  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const rlimit small{std::size_t{1} << 20, before.rlim_max};
  auto* const handler = ::signal(SIGXFSZ, SIG_IGN);
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  const std::string message = message_of<EnvironmentError>([&] { store.append({large}); });
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &before), 0);
  ::signal(SIGXFSZ, handler);

  expect_line(message, {file.string(), "cannot be written"});
  EXPECT_EQ(all_rows(store).size(), 3U);
  store.append({solved_row(4, "b", "trap-u/20/1")});
  EXPECT_EQ(all_rows(store).size(), 4U);
}

// --- damaged rows ------------------------------------------------------------------------------------

struct Damage {
  std::string sql;     ///< done to row 2 of three
  std::string column;  ///< that must be named
};

TEST(StoreRead, NamesTheRowAndTheColumnThatCannotBeRead) {
  const std::vector<Damage> damages = {
      {"UPDATE trial SET verdict = 'solvd' WHERE number = 2", "verdict"},
      {"UPDATE trial SET digest = 'xyz' WHERE number = 2", "digest"},
      {"UPDATE trial SET digest = '00000000000000AB' WHERE number = 2", "digest"},
      {"UPDATE trial SET length = 'long' WHERE number = 2", "length"},
      {"UPDATE trial SET gap = x'00' WHERE number = 2", "gap"},
      {"INSERT INTO scenario VALUES (9, 'x', 'strict'); INSERT INTO reference VALUES (9, 'lattice', 'far'); "
       "UPDATE trial SET scenario = 9 WHERE number = 2",
       "optimum"},
      {"UPDATE trial SET turns = -1 WHERE number = 2", "turns"},
      {"UPDATE trial SET turns = 1.5 WHERE number = 2", "turns"},
      {"UPDATE trial SET evaluations = -1 WHERE number = 2", "evaluations"},
      {"UPDATE trial SET checks = 'three' WHERE number = 2", "checks"},
      {"UPDATE trial SET seed = '18446744073709551616' WHERE number = 2", "seed"},
      {"UPDATE trial SET timed = 2 WHERE number = 2", "timed"},
      {"UPDATE trial SET wall_s = 'soon' WHERE number = 2", "wall_s"},
      {"UPDATE trial SET threads = 4294967296 WHERE number = 2", "threads"},
      {"UPDATE trial SET note = x'00ff' WHERE number = 2", "note"},
      {"UPDATE trial SET scenario = 77 WHERE number = 2", "scenario"},
      {"UPDATE trial SET planner = 77 WHERE number = 2", "planner"},
      {"UPDATE answer SET path = '0,0 1;0' WHERE trial = 2", "path"},
      {"UPDATE answer SET path = '0,0 1' WHERE trial = 2", "path"},
      {"UPDATE answer SET path = '0,0  1,1' WHERE trial = 2", "path"},
      {"UPDATE answer SET path = '0,0 1,1 ' WHERE trial = 2", "path"},
      {"UPDATE answer SET path = NULL WHERE trial = 2", "path"},
      {"UPDATE answer SET path_track = NULL WHERE trial = 2", "path_track"},
      {"UPDATE answer SET path_track = 'lattise' WHERE trial = 2", "path_track"},
      {"UPDATE answer SET trace = '1,2,3' WHERE trial = 2", "trace"},
      {"UPDATE answer SET trace = '1,2,3,0.1,2,5' WHERE trial = 2", "trace"},
      {"UPDATE answer SET trace = '1,2,-3,0.1,2' WHERE trial = 2", "trace"},
      {"UPDATE answer SET counters = 'arrived' WHERE trial = 2", "counters"},
      {"UPDATE answer SET counters = 'arrived=-1' WHERE trial = 2", "counters"},
      {"UPDATE answer SET counters = '=1' WHERE trial = 2", "counters"},
      {"DELETE FROM answer WHERE trial = 2", "trace"},
  };
  for (const Damage& damage : damages) {
    SCOPED_TRACE(damage.sql);
    const TemporaryFolder folder;
    const fs::path file = stored(folder);
    run_sql(file, damage.sql);
    const Store store = Store::open(file, Access::read);
    std::size_t seen = 0;
    expect_line(message_of<InputError>([&] { store.for_each([&seen](const TrialRow&) { ++seen; }); }),
                {file.string(), "damaged", hex(2), "'" + damage.column + "'"});
    EXPECT_EQ(seen, 1U);
  }
}

TEST(StoreRead, NamesTheRowBeforeOneWhoseKeyCannotBeRead) {
  const TemporaryFolder folder;
  const fs::path file = stored(folder);
  run_sql(file, "UPDATE trial SET key = 'none' WHERE number = 2");
  const Store store = Store::open(file, Access::read);
  expect_line(message_of<InputError>([&] { store.keys(); }), {file.string(), hex(1), "'key'", "'none'"});
  expect_line(message_of<InputError>([&] { all_rows(store); }), {file.string(), hex(1), "'key'", "'none'"});
}

TEST(StoreRead, SaysAfterWhichRowTheFileIsDamaged) {
  const TemporaryFolder folder;
  const fs::path file = stored(folder, 2000);
  // Overwrite a page deep inside the table of trials, found by a note that only row 1500 has.
  run_sql(file, "UPDATE trial SET note = 'overwrite here' WHERE number = 1500");
  std::string content = read_file(file);
  const std::size_t page = 4096;
  const std::size_t place = content.find("overwrite here");
  ASSERT_NE(place, std::string::npos);
  content.replace(place / page * page, page, std::string(page, '\x5A'));
  write_file(file, content);
  const Store store = Store::open(file, Access::read);
  std::uint64_t last = 0;
  const std::string message =
      message_of<InputError>([&] { store.for_each_slim([&last](const TrialRow& row) { last = row.key; }); });
  EXPECT_GT(last, 0U);
  EXPECT_LT(last, 1500U);
  expect_line(message, {file.string(), "damaged", hex(last)});
}

}  // namespace
}  // namespace pathrace::results
