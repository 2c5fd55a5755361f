// `verify` finds what was altered in a store, and names the row.
#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>

#include "tests/bench/command_line.hpp"
#include "tests/support/process.hpp"
#include "tests/support/trials.hpp"

namespace pathrace::bench {
namespace {

using testing::Finished;
using testing::run_program;
using testing::ScratchFolder;

class Verify : public ::testing::Test {
 protected:
  Verify() {
    const Finished run = run_program(
        PATHRACE_BINARY, {"run", "--campaign", "smoke", "--out", folder(), "--backend", "threads"});
    EXPECT_EQ(run.exit_code, 0) << run.err;
  }

  std::string folder() const { return scratch_ / "run"; }

  Finished verify(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{"verify", folder(), "--backend", "threads"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_program(PATHRACE_BINARY, arguments);
  }

  // Alters the row that the statement `choose` names; returns its key.
  std::string alter(const std::string& update) const {
    SQLite::Database store(folder() + "/results.db", SQLite::OPEN_READWRITE);
    const std::string key =
        store
            .execAndGet("SELECT key FROM trials WHERE verdict = 'solved' AND length > 5 ORDER BY key LIMIT 1")
            .getString();
    SQLite::Statement statement(store, update);
    statement.bind(1, key);
    EXPECT_EQ(statement.exec(), 1);
    return key;
  }

  ScratchFolder scratch_;
};

TEST_F(Verify, FindsEveryDigestOfAnUntouchedStoreEqual) {
  const Finished result = verify();
  EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
  EXPECT_NE(result.out.find("464 run again"), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("all equal"), std::string::npos) << result.out;
}

TEST_F(Verify, ASampleRunsOnlySomeOfThem) {
  const Finished result = verify({"--sample", "7"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_NE(result.out.find("7 run again"), std::string::npos) << result.out;
}

TEST_F(Verify, NamesTheRowWhoseDigestWasAltered) {
  const std::string key = alter("UPDATE trial SET digest = 'feedfacefeedface' WHERE key = ?");
  for (const std::vector<std::string>& more : {std::vector<std::string>{}, {"--sample", "1"}}) {
    const Finished result = verify(more);
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_NE(result.out.find(key), std::string::npos) << result.out;
  }
}

TEST_F(Verify, NamesTheRowWhosePathWasAltered) {
  const std::string key = alter(
      "UPDATE answer SET path = replace(path, '1,', '2,') WHERE trial = (SELECT number FROM trial WHERE key "
      "= ?)");
  const Finished result = verify({"--sample", "1"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_NE(result.out.find(key), std::string::npos) << result.out;
}

TEST_F(Verify, NamesTheRowWhoseLengthWasAltered) {
  const std::string key = alter("UPDATE trial SET length = length - 1 WHERE key = ?");
  const Finished result = verify();
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_NE(result.out.find(key), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("length"), std::string::npos) << result.out;
}

TEST_F(Verify, NamesARowWhoseTimeWasAlteredAndNobodyElseShowsIt) {
  const std::string key = alter("UPDATE trial SET wall_s = wall_s / 2 WHERE key = ?");
  const Finished result = verify({"--sample", "1"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_NE(result.out.find(key), std::string::npos) << result.out;
  expect_refusal(pathrace({"leaderboard", folder()}), {"results.db", key, "changed"});
  expect_refusal(pathrace({"digest", folder()}), {"results.db", key, "changed"});
  expect_refusal(pathrace({"run", "--resume", "--out", folder()}), {"results.db", key, "changed"});
}

TEST_F(Verify, MissesARowThatWasRemoved) {
  alter("DELETE FROM trial WHERE key = ?");
  const Finished result = verify();
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_NE(result.out.find("463 trials where 464 were recorded"), std::string::npos) << result.out;
  expect_refusal(pathrace({"leaderboard", folder()}), {"results.db", "463", "464"});
  expect_refusal(pathrace({"digest", folder()}), {"results.db", "463", "464"});
  expect_refusal(pathrace({"run", "--resume", "--out", folder()}), {"results.db", "463", "464"});
}

TEST_F(Verify, NamesARowThatBelongsToNoTrial) {
  alter("UPDATE trial SET key = '0123456789abcdef' WHERE key = ?");
  const Finished result = verify();
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_NE(result.out.find("0123456789abcdef"), std::string::npos) << result.out;
}

}  // namespace
}  // namespace pathrace::bench
