#include "results/trials_csv.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>

#include <sstream>

#include "tests/results/rows.hpp"

namespace pathrace::results {
namespace {

std::string trials_csv(const Store& store) {
  std::ostringstream out;
  write_trials_csv(out, store);
  return out.str();
}

std::string view_columns(const std::filesystem::path& file) {
  const SQLite::Database database(file);
  SQLite::Statement statement(database, "SELECT name FROM pragma_table_info('trials') ORDER BY cid");
  std::string names;
  while (statement.executeStep()) names += (names.empty() ? "" : ",") + statement.getColumn(0).getString();
  return names;
}

TEST(TrialsCsv, HasTheColumnsOfTheViewInItsOrder) {
  const TemporaryFolder folder;
  const Store store = Store::create(folder / "results.db", some_identity());
  const std::string columns = view_columns(folder / "results.db");
  EXPECT_EQ(trials_csv(store), columns + "\n");
  const std::string agreed =
      "key,scenario,planner,repetition,seed,verdict,track,length,optimum,gap,turns,evaluations,iterations,"
      "checks,"
      "digest,wall_s,";
  EXPECT_EQ(columns.substr(0, agreed.size()), agreed);
}

TEST(TrialsCsv, HasALinePerTrialAndNothingForNothing) {
  const TemporaryFolder folder;
  Store store = Store::create(folder / "results.db", some_identity());
  TrialRow solved = solved_row(255, "as:a=1,b=2", "trap-u/20/1");
  solved.digest = 1;
  solved.gap = 0.5;
  TrialRow failed = failed_row(256, "as", "trap-u/20/1");
  failed.digest = 2;
  failed.note = "said \"no\"";
  store.append({solved, failed});
  const std::string text = trials_csv(store);
  EXPECT_EQ(
      text.substr(text.find('\n') + 1),
      "00000000000000ff,trap-u/20/1,\"as:a=1,b=2\",0,0,solved,lattice,2,2,0.5,0,1,1,3,0000000000000001,0.001,"
      "strict,\"as:a=1,b=2:a=1,b=2\",1,evaluations=100,,0,1,1,0,0.0005,serial,1,1,0,,,,,,,,,,,,,0,\n"
      "0000000000000100,trap-u/20/1,as,0,0,budget,lattice,,2,,,1,1,3,0000000000000002,0.001,"
      "strict,\"as:a=1,b=2\",1,evaluations=100,\"said "
      "\"\"no\"\"\",,,,0,0.0005,serial,1,1,0,,,,,,,,,,,,,0,\n");
}

TEST(TrialsView, ShowsWhatTheTablesHold) {
  const TemporaryFolder folder;
  Store::create(folder / "results.db", some_identity()).append({solved_row(255, "as", "trap-u/20/1")});
  const SQLite::Database database(folder / "results.db");
  SQLite::Statement statement(database,
                              "SELECT scenario, planner, length, optimum, rule, call FROM trials "
                              "WHERE key = '00000000000000ff'");
  ASSERT_TRUE(statement.executeStep());
  EXPECT_EQ(statement.getColumn(0).getString(), "trap-u/20/1");
  EXPECT_EQ(statement.getColumn(1).getString(), "as");
  EXPECT_EQ(statement.getColumn(2).getDouble(), 2);
  EXPECT_EQ(statement.getColumn(3).getDouble(), 2);
  EXPECT_EQ(statement.getColumn(4).getString(), "strict");
  EXPECT_EQ(statement.getColumn(5).getString(), "as:a=1,b=2");
}

}  // namespace
}  // namespace pathrace::results
