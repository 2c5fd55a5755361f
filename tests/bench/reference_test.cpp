// References of the any-angle track: proven by the search that the oracle proves, the same everywhere.
#include "bench/reference.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <numbers>
#include <numeric>

#include "bench/run_folder.hpp"
#include "bench/runner.hpp"
#include "results/store.hpp"
#include "scenarios/library.hpp"
#include "tests/support/any_angle_oracle.hpp"
#include "tests/support/oracle.hpp"
#include "tests/support/process.hpp"
#include "tests/support/trials.hpp"

namespace pathrace::bench {
namespace {

using testing::Finished;
using testing::grid_of;
using testing::Question;
using testing::run_program;
using testing::scenario_of;
using testing::ScratchFolder;

AnyAngleOptimum reference_of(const Question& question, MoveRule rule = MoveRule::strict) {
  Scenario scenario = scenario_of(question, rule);
  prove_reference(scenario, Track::any_angle, Referee(scenario.terrain));
  return scenario.any_angle_optimum;
}

TEST(Reference, OfTheAnyAngleTrackIsTheOraclesLengthUnderEveryMoveRule) {
  for (std::uint64_t i = 0; i < 150; ++i) {
    const Question question = testing::random_question(Stream(211).fork(i), 8, 0.45);
    const auto expected = testing::oracle_any_angle(question.grid, question.start, question.goal);
    const AnyAngleOptimum reference = reference_of(question);
    ASSERT_TRUE(reference.proven);
    ASSERT_EQ(reference.length.has_value(), expected.has_value()) << i;
    if (expected) {
      ASSERT_NEAR(*reference.length, *expected, 1e-12 * (1 + *expected)) << i;
    }
    for (const MoveRule rule : testing::all_rules) {
      ASSERT_EQ(reference_of(question, rule).length, reference.length) << i << ' ' << name(rule);
    }
  }
}

TEST(Reference, IsProvenForTheTrackThatAsksAndStandsOnceItIsProven) {
  Scenario scenario = scenario_of({grid_of({"...", ".#.", "..."}), {0, 1}, {2, 1}});
  const Referee referee(scenario.terrain);
  prove_reference(scenario, Track::dynamic, referee);
  EXPECT_FALSE(scenario.optimum.proven || scenario.any_angle_optimum.proven);
  prove_reference(scenario, Track::lattice, referee);
  EXPECT_EQ(scenario.optimum.length, (LatticeLength{4, 0}));
  EXPECT_FALSE(scenario.any_angle_optimum.proven);
  scenario.any_angle_optimum = {true, 7};
  prove_reference(scenario, Track::any_angle, referee);
  EXPECT_EQ(scenario.any_angle_optimum.length, 7);
}

TEST(Reference, OfADynamicWorldIsItsOwnBound) {
  Scenario scenario = scenarios::Library().load("discs/open/1");
  prove_reference(scenario, Track::any_angle, Referee(scenario.terrain));
  EXPECT_FALSE(scenario.any_angle_optimum.proven);
}

TEST(Reference, IsTheNumberThatPlanPrints) {
  // From (0,1) by the corners (0.5,0.5) and (1.5,0.5) to (2,1): 1 + sqrt 2.
  const ScratchFolder scratch;
  const std::string map = scratch.file("block.map", "type octile\nheight 3\nwidth 3\nmap\n...\n.@.\n...\n");
  const auto plan = [&](const std::string& planner) {
    const Finished finished = run_program(PATHRACE_BINARY, {"plan", "--map", map, "--start", "0,1", "--goal",
                                                            "2,1", "--planner", planner, "--json"});
    EXPECT_EQ(finished.exit_code, 0) << finished.err;
    return nlohmann::json::parse(finished.out);
  };
  const double corner_to_corner = 1 + std::numbers::sqrt2;
  const auto exact = plan("any-angle-optimum");
  EXPECT_NEAR(exact["optimum"].get<double>(), corner_to_corner, 1e-15);
  EXPECT_EQ(exact["length"], exact["optimum"]);
  EXPECT_EQ(exact["gap"], 0);
  const auto theta = plan("theta-star");
  EXPECT_EQ(theta["optimum"], exact["optimum"]);
  EXPECT_NEAR(theta["gap"].get<double>(), theta["length"].get<double>() / corner_to_corner - 1, 1e-15);
  EXPECT_GT(theta["gap"], 0.1);
  EXPECT_EQ(plan("astar")["optimum"], 4);
}

constexpr const char* both_tracks = R"([campaign]
name = "both tracks"
repetitions = 2
[budget]
evaluations = 200
[[planner]]
name = "astar"
[[planner]]
name = "theta-star"
[[planner]]
name = "lazy-theta-star"
[[planner]]
name = "any-angle-optimum"
[[planner]]
name = "pso"
[[scenarios]]
select = ["trap-u/20/1..4", "dense/20-20/1..8", "asr/*"]
)";

TEST(Reference, IsTheSameOnEveryExecutorAndForAllTrialsOfAScenario) {
  const TrialPlan plan = plan_trials(parse_campaign(both_tracks, "test"), scenarios::Library(), roster());
  std::vector<std::size_t> trials(plan.size());
  std::iota(trials.begin(), trials.end(), std::size_t{0});
  const std::atomic<bool> never{false};
  std::map<std::string, double> expected;
  for (const std::string& backend : testing::executors_under_test()) {
    for (const int jobs : {1, 2}) {
      std::mutex mutex;
      run_trials(plan, trials, {backend, jobs, 1}, never,
                 [&](const Trial&, const Scenario& scenario, const TrialRecord&) {
                   const std::lock_guard lock(mutex);
                   ASSERT_TRUE(scenario.any_angle_optimum.length.has_value()) << scenario.id;
                   const double length = *scenario.any_angle_optimum.length;
                   EXPECT_EQ(expected.emplace(scenario.id, length).first->second, length)
                       << scenario.id << ' ' << backend << ' ' << jobs;
                 });
    }
  }
  EXPECT_EQ(expected.size(), 15U);
}

TEST(Reference, IsProvenByARunOnlyForTheTracksThatRace) {
  const std::string text = R"([campaign]
name = "on cells"
[[planner]]
name = "astar"
[[scenarios]]
select = ["asr/fig5"]
)";
  const TrialPlan plan = plan_trials(parse_campaign(text, "test"), scenarios::Library(), roster());
  const std::atomic<bool> never{false};
  run_trials(plan, {0}, {"serial", 1, 1}, never,
             [](const Trial&, const Scenario& scenario, const TrialRecord&) {
               EXPECT_TRUE(scenario.optimum.proven);
               EXPECT_FALSE(scenario.any_angle_optimum.proven);
             });
}

class StoredReferences : public ::testing::Test {
 protected:
  StoredReferences() : campaign_(scratch_.file("both.toml", both_tracks)) {
    const Finished run = pathrace({"run", campaign_, "--out", folder()});
    EXPECT_EQ(run.exit_code, 0) << run.err;
  }

  static Finished pathrace(std::vector<std::string> arguments) {
    return run_program(PATHRACE_BINARY, arguments);
  }
  std::string folder() const { return scratch_ / "run"; }
  // As if the rows that are not there had never been recorded.
  void forget(SQLite::Database& database) const {
    database.exec("UPDATE meta SET value = (SELECT count(*) FROM trial) WHERE name = 'recorded'");
    std::filesystem::remove(folder() + "/results.db-lock");
  }
  results::Store store() const { return open_store({folder()}); }

  ScratchFolder scratch_;
  std::string campaign_;
};

TEST_F(StoredReferences, AreWhatEveryGapCountsFromAndNoGapIsNegative) {
  std::map<std::string, double> references;
  store().for_each_scenario([&](const results::ScenarioRow& row) {
    ASSERT_TRUE(row.optimum && row.any_angle_optimum);
    EXPECT_LE(*row.any_angle_optimum, *row.optimum * (1 + 1e-12)) << row.id;
    references[row.id] = *row.any_angle_optimum;
  });
  EXPECT_EQ(references.size(), 15U);
  std::size_t longer = 0;
  store().for_each([&](const results::TrialRow& row) {
    if (row.track != Track::any_angle) return;
    EXPECT_EQ(row.optimum, references.at(row.scenario)) << row.scenario;
    if (!row.gap) return;
    EXPECT_GE(*row.gap, 0) << row.planner << ' ' << row.scenario;
    EXPECT_NEAR(*row.gap, *row.length / *row.optimum - 1, 1e-12);
    if (row.planner == "any-angle-optimum") {
      EXPECT_EQ(row.gap, 0.0) << row.scenario;
    }
    longer += *row.gap > 0 ? 1 : 0;
  });
  EXPECT_GT(longer, 20U);
}

TEST_F(StoredReferences, AreFoundAgainByVerifyAndByAResumedRun) {
  const Finished verify = pathrace({"verify", folder()});
  EXPECT_EQ(verify.exit_code, 0) << verify.out << verify.err;
  {
    SQLite::Database database(folder() + "/results.db", SQLite::OPEN_READWRITE);
    database.exec("DELETE FROM answer WHERE trial > 50; DELETE FROM trial WHERE number > 50");
    forget(database);
  }
  const Finished resumed = pathrace({"run", "--resume", "--out", folder()});
  EXPECT_EQ(resumed.exit_code, 0) << resumed.err;
  EXPECT_EQ(store().size(), 150U);
}

TEST_F(StoredReferences, ThatWereAlteredAreNamed) {
  {
    SQLite::Database database(folder() + "/results.db", SQLite::OPEN_READWRITE);
    database.exec("UPDATE reference SET length = length + 1 WHERE track = 'any_angle'");
  }
  const Finished verify = pathrace({"verify", folder()});
  EXPECT_EQ(verify.exit_code, 1);
  EXPECT_NE(verify.out.find("optimum: stored"), std::string::npos) << verify.out;
  {
    SQLite::Database database(folder() + "/results.db", SQLite::OPEN_READWRITE);
    database.exec(  // of a planner on that track: which trial is the last one is chance
        "CREATE TEMP TABLE one AS SELECT number FROM trial WHERE key IN"
        " (SELECT key FROM trials WHERE track = 'any_angle') LIMIT 1;"
        "DELETE FROM answer WHERE trial IN one; DELETE FROM trial WHERE number IN one");
    forget(database);
  }
  const Finished resumed = pathrace({"run", "--resume", "--out", folder()});
  EXPECT_EQ(resumed.exit_code, 2);
  EXPECT_NE(resumed.err.find("was changed after it was recorded"), std::string::npos) << resumed.err;
}

}  // namespace
}  // namespace pathrace::bench
