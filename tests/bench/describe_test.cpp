// Describing scenarios for a store and on the command line: the same values everywhere, computed once.
#include "bench/describe.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "bench/features/feature.hpp"
#include "scenarios/library.hpp"
#include "tests/support/process.hpp"
#include "tests/support/trials.hpp"

namespace pathrace::bench {
namespace {

using testing::Finished;
using testing::run_program;
using testing::ScratchFolder;

constexpr const char* campaign_text = R"([campaign]
name = "described"
[budget]
evaluations = 20
checks = 4000
[[planner]]
name = "greedy"
[[scenarios]]
select = ["trap-u/20/1", "asr/*", "dense/20-20/1..20"]
)";
constexpr std::size_t campaign_scenarios = 24;

Finished pathrace(std::vector<std::string> arguments) {
  return run_program(PATHRACE_BINARY, arguments);
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::string read(const std::string& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

std::vector<results::ScenarioRow> rows_of(const results::Store& store) {
  std::vector<results::ScenarioRow> rows;
  store.for_each_scenario([&rows](const results::ScenarioRow& row) { rows.push_back(row); });
  return rows;
}

struct Described {
  TrialPlan plan = plan_trials(parse_campaign(campaign_text, "test"), scenarios::Library(), roster());
  ScratchFolder scratch;
  results::Store store = results::Store::create(scratch / "results.db", {"described", "", 1, 1, 1});
  std::atomic<bool> stop{false};

  std::size_t describe(bool with_features, const RunOptions& options = {"serial", 1, 1}) {
    return store_scenarios(plan, with_features, options, stop, store);
  }
};

TEST(Describe, StoresEveryScenarioOfThePlanInItsOrderOnEveryExecutor) {
  std::vector<results::ScenarioRow> expected;
  for (const std::string& backend : testing::executors_under_test()) {
    for (const int jobs : {1, 2}) {
      Described run;
      EXPECT_EQ(run.describe(true, {backend, jobs, 1}), campaign_scenarios);
      const auto rows = rows_of(run.store);
      ASSERT_EQ(rows.size(), campaign_scenarios);
      EXPECT_EQ(rows[0].id, "trap-u/20/1");
      EXPECT_EQ(rows[0].features.size(), features().size());
      if (expected.empty()) expected = rows;
      EXPECT_EQ(rows, expected) << backend << ", " << jobs << " jobs";
    }
  }
}

TEST(Describe, DoesNotComputeTwiceWhatIsStored) {
  Described run;
  EXPECT_EQ(run.describe(false), campaign_scenarios);
  EXPECT_EQ(run.describe(false), 0U);
  EXPECT_EQ(rows_of(run.store)[0].features.size(), 0U);
  EXPECT_EQ(run.describe(true), campaign_scenarios);  // the features are still missing
  EXPECT_EQ(run.describe(true), 0U);
  EXPECT_EQ(run.describe(false), 0U);
  EXPECT_EQ(rows_of(run.store)[0].features.size(), features().size());
}

TEST(Describe, GoesOnWithTheScenariosThatAnInterruptedRunLeft) {
  Described whole;
  whole.describe(true);
  Described halved;
  std::vector<Scenario> all = halved.plan.scenarios;
  halved.plan.scenarios.resize(10);
  EXPECT_EQ(halved.describe(true), 10U);
  halved.plan.scenarios = all;
  halved.stop = true;
  EXPECT_EQ(halved.describe(true), 0U);
  halved.stop = false;
  EXPECT_EQ(halved.describe(true), campaign_scenarios - 10);
  EXPECT_EQ(rows_of(halved.store), rows_of(whole.store));
}

TEST(ScenarioFeatures, AreListedAsCsv) {
  const Finished plain = pathrace({"scenarios", "list", "--family", "asr/fig5", "--csv"});
  ASSERT_EQ(plain.exit_code, 0) << plain.err;
  const auto lines = lines_of(plain.out);
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[0],
            "id,family,width,height,rule,start_x,start_y,goal_x,goal_y,optimum,any_angle_optimum,hash");
  EXPECT_TRUE(lines[1].starts_with("asr/fig5,asr,5,5,strict,0,0,4,4,6.24264068711928"))
      << lines[1];  // 2 + 3 sqrt 2

  const auto with_features =
      lines_of(pathrace({"scenarios", "list", "--family", "asr/fig5", "--csv", "--features"}).out);
  ASSERT_EQ(with_features.size(), 2U);
  EXPECT_EQ(with_features[0],
            lines[0] +
                ",density,detour,expansions,optimal_paths_log10,dead_end_share,trap_depth,clearance_min,"
                "clearance_mean,arrival_rate");
  EXPECT_TRUE(with_features[1].starts_with(lines[1] + ",0.08,1.10355339059327"))
      << with_features[1];  // 2 of 25
}

TEST(ScenarioFeatures, AreListedAsJsonAndAsATable) {
  using Json = nlohmann::json;
  const Json list =
      Json::parse(pathrace({"scenarios", "list", "--family", "asr", "--json", "--features"}).out);
  ASSERT_EQ(list.size(), 3U);
  for (const Feature& feature : features()) {
    EXPECT_EQ(list[0]["features"][feature.name].is_number_integer(), feature.type == FeatureType::integer)
        << feature.name;
  }
  EXPECT_NEAR(list[1]["features"]["optimal_paths_log10"].get<double>(), std::log10(2.0), 1e-15);  // fig5: two
  EXPECT_FALSE(
      Json::parse(pathrace({"scenarios", "list", "--family", "asr", "--json"}).out)[0].contains("features"));
  const auto table = lines_of(pathrace({"scenarios", "list", "--family", "asr", "--features"}).out);
  ASSERT_EQ(table.size(), 4U);
  EXPECT_EQ(table[0].size(), table[1].size());
  EXPECT_NE(table[0].find("trap_depth"), std::string::npos);
  EXPECT_EQ(pathrace({"scenarios", "list", "--csv", "--json"}).exit_code, 2);
}

TEST(ScenarioFeatures, AreTheSameForEveryExecutor) {
  std::string expected;
  for (const std::string& backend : testing::executors_under_test()) {
    for (const char* threads : {"1", "2"}) {
      const Finished list =
          run_program(PATHRACE_BINARY, {"scenarios", "list", "--family", "trap-l/20", "--csv", "--features",
                                        "--backend", backend, "--threads", threads});
      ASSERT_EQ(list.exit_code, 0) << list.err;
      if (expected.empty()) expected = list.out;
      EXPECT_EQ(list.out, expected) << backend << " " << threads;
    }
  }
}

TEST(ScenarioFeatures, AreStoredByARunAndWrittenBesideItsTrials) {
  const ScratchFolder scratch;
  const std::string campaign = scratch.file("campaign.toml", campaign_text);
  const Finished run = pathrace({"run", campaign, "--out", scratch / "run"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto written = lines_of(read(scratch / "run/scenarios.csv"));
  ASSERT_EQ(written.size(), 1 + campaign_scenarios);
  // The listing computes afresh what the run has stored.
  const auto listed = lines_of(pathrace({"scenarios", "list", "--family", "asr", "--csv", "--features"}).out);
  ASSERT_EQ(listed.size(), 4U);
  EXPECT_EQ(written[0], listed[0]);
  for (std::size_t i = 1; i <= 3; ++i) EXPECT_EQ(written[1 + i], listed[i]);
}

TEST(ScenarioFeatures, MoveNoDigestAndMayBeLeftOutAndAddedLater) {
  const ScratchFolder scratch;
  const std::string campaign = scratch.file("campaign.toml", campaign_text);
  ASSERT_EQ(pathrace({"run", campaign, "--out", scratch / "with"}).exit_code, 0);
  ASSERT_EQ(pathrace({"run", campaign, "--out", scratch / "without", "--no-features"}).exit_code, 0);
  const std::string digest = run_program(PATHRACE_BINARY, {"digest", scratch / "with"}).out;
  EXPECT_EQ(run_program(PATHRACE_BINARY, {"digest", scratch / "without"}).out, digest);
  const auto without = lines_of(read(scratch / "without/scenarios.csv"));
  ASSERT_EQ(without.size(), 1 + campaign_scenarios);
  EXPECT_TRUE(without[0].ends_with(",optimum,any_angle_optimum,hash")) << without[0];

  ASSERT_EQ(pathrace({"run", "--resume", "--out", scratch / "without"}).exit_code, 0);
  EXPECT_EQ(read(scratch / "without/scenarios.csv"), read(scratch / "with/scenarios.csv"));
  EXPECT_EQ(run_program(PATHRACE_BINARY, {"digest", scratch / "without"}).out, digest);
}

}  // namespace
}  // namespace pathrace::bench
