// Scenarios and their features: into the store, out of it, and as scenarios.csv.
#include "results/scenarios_csv.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>

#include <sstream>

#include "tests/results/rows.hpp"

namespace pathrace::results {
namespace {

ScenarioRow some_scenario(const std::string& id) {
  ScenarioRow row;
  row.id = id;
  row.width = 20;
  row.height = 10;
  row.start = {1, 2};
  row.goal = {19, 9};
  row.optimum = 2;
  row.any_angle_optimum = 1.75;
  row.hash = 0xFEDCBA9876543210U;
  row.features = {{"zeal", 0.5}, {"ardour", std::nullopt}};
  return row;
}

std::vector<ScenarioRow> all_scenarios(const Store& store) {
  std::vector<ScenarioRow> rows;
  store.for_each_scenario([&rows](const ScenarioRow& row) { rows.push_back(row); });
  return rows;
}

std::string scenarios_csv(const Store& store) {
  std::ostringstream out;
  write_scenarios_csv(out, store);
  return out.str();
}

TEST(Scenarios, ComeBackAsTheyWereStored) {
  const TemporaryFolder folder;
  std::vector<ScenarioRow> rows = {some_scenario("trap-u/20/1"), some_scenario("curated/\xC3\xA9, 'x'"),
                                   some_scenario("asr/fig2")};
  rows[0].features = {
      {"huge", 1.7976931348623157e308}, {"tiny", 5e-324}, {"third", 1.0 / 3}, {"count", 1e15}};
  rows[1].rule = MoveRule::squeeze;
  rows[1].optimum = std::nullopt;
  rows[2].any_angle_optimum = std::nullopt;
  rows[2].features.clear();
  Store::create(folder / "results.db", some_identity()).describe(rows);
  EXPECT_EQ(all_scenarios(Store::open(folder / "results.db", Access::read)), rows);
}

TEST(Scenarios, ShareTheirRowWithTheirTrialsWhoeverComesFirst) {
  const TemporaryFolder folder;
  {
    Store store = Store::create(folder / "results.db", some_identity());
    store.describe({some_scenario("trap-u/20/1")});
    store.append({solved_row(1, "a", "trap-u/20/1"), solved_row(2, "a", "trap-l/20/1")});
    store.describe({some_scenario("trap-l/20/1")});
    EXPECT_EQ(store.size(), 2U);
    EXPECT_EQ(all_scenarios(store).size(), 2U);
  }
  const SQLite::Database database(folder / "results.db");
  SQLite::Statement count(database, "SELECT count(*) FROM scenario");
  ASSERT_TRUE(count.executeStep());
  EXPECT_EQ(count.getColumn(0).getInt(), 2);
}

TEST(Scenarios, TakeNewFeaturesAndNewValuesAndKeepTheRest) {
  const TemporaryFolder folder;
  Store store = Store::create(folder / "results.db", some_identity());
  ScenarioRow row = some_scenario("trap-u/20/1");
  row.features.clear();
  store.describe({row});
  EXPECT_EQ(store.feature_names(), std::vector<std::string>{});
  row.features = {{"zeal", 1}, {"ardour", 2}};
  store.describe({row});
  row.features = {{"ardour", 3}, {"new", 4}};
  store.describe({row});
  row.features = {{"zeal", 1}, {"ardour", 3}, {"new", 4}};
  EXPECT_EQ(all_scenarios(store), std::vector<ScenarioRow>{row});
  EXPECT_EQ(store.feature_names(), (std::vector<std::string>{"zeal", "ardour", "new"}));
}

TEST(Scenarios, AreStoredAllOrNone) {
  const TemporaryFolder folder;
  Store store = Store::create(folder / "results.db", some_identity());
  {
    SQLite::Database other(folder / "results.db", SQLite::OPEN_READWRITE);
    other.exec(
        "CREATE TRIGGER no_zeal BEFORE INSERT ON feature WHEN NEW.name = 'bad' "
        "BEGIN SELECT RAISE(ABORT, 'no'); END");
  }
  ScenarioRow bad = some_scenario("trap-l/20/1");
  bad.features = {{"bad", 1}};
  EXPECT_THROW(store.describe({some_scenario("trap-u/20/1"), bad}), std::logic_error);
  EXPECT_EQ(all_scenarios(store).size(), 0U);
  store.describe({some_scenario("trap-u/20/1")});  // its number went with the failed batch, and comes back
  EXPECT_EQ(all_scenarios(store), std::vector<ScenarioRow>{some_scenario("trap-u/20/1")});
}

TEST(Scenarios, CannotBeDescribedWhenTheStoreWasOpenedToBeRead) {
  const TemporaryFolder folder;
  Store::create(folder / "results.db", some_identity());
  Store store = Store::open(folder / "results.db", Access::read);
  EXPECT_THROW(store.describe({some_scenario("trap-u/20/1")}), std::logic_error);
}

TEST(Scenarios, ThatAreDamagedAreNamed) {
  const TemporaryFolder folder;
  Store::create(folder / "results.db", some_identity()).describe({some_scenario("trap-u/20/1")});
  SQLite::Database(folder / "results.db", SQLite::OPEN_READWRITE)
      .exec("UPDATE feature SET value = 'much' WHERE name = 'zeal'");
  const Store store = Store::open(folder / "results.db", Access::read);
  const std::string message = message_of<InputError>([&store] { all_scenarios(store); });
  expect_line(message, {"results.db", "'trap-u/20/1'", "column 'value'", "'much'"});
}

TEST(ScenariosCsv, HasAColumnPerFeatureAndNothingForNothing) {
  const TemporaryFolder folder;
  Store store = Store::create(folder / "results.db", some_identity());
  ScenarioRow other = some_scenario("trap,odd/1");
  other.optimum = other.any_angle_optimum = std::nullopt;
  other.features = {{"ardour", 7}};
  store.describe({some_scenario("trap-u/20/1"), other});
  EXPECT_EQ(
      scenarios_csv(store),
      "id,family,width,height,rule,start_x,start_y,goal_x,goal_y,optimum,any_angle_optimum,hash,zeal,ardour\n"
      "trap-u/20/1,trap-u,20,10,strict,1,2,19,9,2,1.75,fedcba9876543210,0.5,\n"
      "\"trap,odd/1\",\"trap,odd\",20,10,strict,1,2,19,9,,,fedcba9876543210,,7\n");
}

TEST(FeaturesView, NamesTheScenarioOfEachValue) {
  const TemporaryFolder folder;
  Store::create(folder / "results.db", some_identity()).describe({some_scenario("trap-u/20/1")});
  const SQLite::Database database(folder / "results.db");
  SQLite::Statement statement(database, "SELECT scenario, rule, value FROM features WHERE name = 'zeal'");
  ASSERT_TRUE(statement.executeStep());
  EXPECT_EQ(statement.getColumn(0).getString(), "trap-u/20/1");
  EXPECT_EQ(statement.getColumn(1).getString(), "strict");
  EXPECT_EQ(statement.getColumn(2).getDouble(), 0.5);
}

}  // namespace
}  // namespace pathrace::results
