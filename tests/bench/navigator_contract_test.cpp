// The contract of navigators: what holds for every one of them, in every kind of world.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>

#include "bench/dynamic_trial.hpp"
#include "core/hash.hpp"
#include "core/run_referee.hpp"
#include "scenarios/library.hpp"
#include "tests/support/trials.hpp"
#include "tests/support/worlds.hpp"

namespace pathrace::testing {
namespace {

Budget steps(std::uint64_t count) {
  Budget budget;
  budget.iterations = count;
  return budget;
}

std::vector<std::string> worlds_under_test() {
  return {"discs/open/1",   "discs/dense/2",    "discs/ring/1",  "discs/ring,inside=goal/2",
          "discs/c-trap/1", "discs/corridor/1", "discs/chase/1", "discs/open,goal=way_points/3"};
}

std::vector<std::string> navigators_under_test() {
  std::vector<std::string> calls;
  for (const PlannerCard& card : bench::roster().cards()) {
    if (card.navigates()) calls.push_back(card.name);
  }
  calls.insert(calls.end(),
               {"d-star-lite:ties=near_robot", "replan(as:ants=10):evaluations=20,resolution=4"});
  return calls;
}

class NavigatorContract : public ::testing::TestWithParam<std::string> {
 protected:
  TrialRecord trial(const Scenario& scenario, const Budget& budget) const {
    return run({GetParam(), budget}, scenario);
  }
};

TEST_P(NavigatorContract, KeepsTheRulesInEveryKindOfWorldAndSeesTheSameWorldAsAll) {
  const scenarios::Library library;
  for (const std::string& id : worlds_under_test()) {
    const Scenario scenario = library.load(id);
    const TrialRecord record = trial(scenario, steps(60));
    ASSERT_TRUE(record.run.has_value()) << id << ": " << name(record.verdict) << ' ' << record.note;
    EXPECT_EQ(record.run->world_hash, content_hash(scenario)) << id;
    EXPECT_EQ(record.work.iterations, record.run->steps) << id;
    EXPECT_EQ(record.answer->points.size(), record.run->steps + 1) << id;
    EXPECT_TRUE(record.verdict != Verdict::solved || record.run->steps >= *scenario.world->least_steps) << id;
  }
}

TEST_P(NavigatorContract, ToAStandingGoalWithoutDiscsItDrivesStraight) {
  World world = still_world();
  for (const double goal_x : {13.5, 27.0, 61.2, 90.0}) {
    world.goal = {goal_x, 50};
    const TrialRecord record = trial(scenario_of(world), {});
    ASSERT_EQ(record.verdict, Verdict::solved) << goal_x << ": " << record.note;
    const double exact = std::ceil((goal_x - 10 - 3) / 3);
    EXPECT_LE(std::abs(static_cast<double>(record.run->steps) - exact), 1) << goal_x;
  }
}

TEST_P(NavigatorContract, ARobotThatIsThereAlreadyTakesNoStep) {
  World world = still_world();
  world.goal = {12, 51};
  const TrialRecord record = trial(scenario_of(world), {});
  ASSERT_EQ(record.verdict, Verdict::solved) << record.note;
  EXPECT_EQ(record.run->steps, 0U);
}

TEST_P(NavigatorContract, ABudgetIsNeverExceededWhateverItLimits) {
  const Scenario scenario = scenarios::Library().load("discs/open/2");
  for (const std::uint64_t limit : {1U, 2U, 7U, 33U, 500U}) {
    for (auto member : {&Budget::evaluations, &Budget::iterations, &Budget::checks}) {
      Budget budget;
      budget.iterations = 20;
      budget.*member = limit;
      const TrialRecord record = trial(scenario, budget);
      EXPECT_EQ(record.note.find("exceeded"), std::string::npos) << to_string(budget) << ": " << record.note;
      EXPECT_LE(record.work.iterations, *budget.iterations);
      EXPECT_TRUE(!budget.evaluations || record.work.evaluations <= limit) << to_string(budget);
      EXPECT_TRUE(!budget.checks || record.work.checks <= limit) << to_string(budget);
    }
  }
}

TEST_P(NavigatorContract, TheSameSeedGivesTheSameRecordOnEveryExecutorAndNumberOfThreads) {
  const scenarios::Library library;
  for (const char* id : {"discs/open/1", "discs/ring/2", "discs/chase/1"}) {
    const Scenario scenario = library.load(id);
    const std::uint64_t expected = digest(run({GetParam(), steps(15)}, scenario));
    for (const std::string& backend : executors_under_test()) {
      for (const int threads : {1, 2, 4}) {
        EXPECT_EQ(digest(run({GetParam(), steps(15), backend, threads}, scenario)), expected)
            << id << ": " << backend << " with " << threads << " threads";
      }
    }
  }
}

TEST_P(NavigatorContract, ItRepeatsWhateverTheSeedIfItDrawsNothing) {
  if (bench::roster().enter(parse_call(GetParam())).draws()) GTEST_SKIP() << "draws random numbers";
  const Scenario scenario = scenarios::Library().load("discs/dense/2");
  EXPECT_EQ(digest(run({GetParam(), steps(15), "serial", 1, 1}, scenario)),
            digest(run({GetParam(), steps(15), "serial", 1, 2}, scenario)));
}

TEST_P(NavigatorContract, ARunDoesNotDependOnTheRunBefore) {
  const scenarios::Library library;
  const Scenario one = library.load("discs/open/1");
  const Scenario two = library.load("discs/dense/1");
  const std::uint64_t first = digest(run({GetParam(), steps(15)}, one));
  run({GetParam(), steps(15)}, two);
  EXPECT_EQ(digest(run({GetParam(), steps(15)}, one)), first);
}

TEST_P(NavigatorContract, NothingDependsOnBeingWatched) {
  const Scenario scenario = scenarios::Library().load("discs/open/3");
  const Entrant entrant = bench::roster().enter(parse_call(GetParam()));
  const auto executor = bench::make_executor("serial", 1);
  const auto record = [&](const bench::WatchStep& watch) {
    return digest(bench::run_dynamic_trial(entrant, *scenario.world, steps(15), Stream(3), *executor, watch));
  };
  std::size_t seen = 0;
  const std::uint64_t watched =
      record([&seen](const Snapshot& snapshot, Point, const Overlay&) { EXPECT_EQ(snapshot.step, seen++); });
  EXPECT_EQ(record({}), watched);
  EXPECT_EQ(seen, 15U);
}

TEST_P(NavigatorContract, AMapThatStandsStillIsUnsupported) {
  const TrialRecord record = trial(scenarios::Library().load("asr/fig2"), {});
  EXPECT_EQ(record.verdict, Verdict::unsupported);
}

std::string test_name(const ::testing::TestParamInfo<std::string>& info) {
  std::string text = info.param;
  std::replace_if(
      text.begin(), text.end(), [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
  return text;
}

INSTANTIATE_TEST_SUITE_P(All, NavigatorContract, ::testing::ValuesIn(navigators_under_test()), test_name);

// Like the signatures of planners: from running the code, moved by any change of behaviour.
const std::map<std::string, std::string>& known_signatures() {
  static const std::map<std::string, std::string> signatures = {
#include "tests/bench/navigator_signatures.inc"
  };
  return signatures;
}

TEST_P(NavigatorContract, ItsSignatureIsTheKnownOne) {
  const scenarios::Library library;
  Hasher hasher;
  for (const std::string& id : worlds_under_test()) {
    hasher.add(digest(run({GetParam(), steps(25)}, library.load(id))));
  }
  const auto known = known_signatures().find(GetParam());
  ASSERT_NE(known, known_signatures().end())
      << GetParam() << " has no signature yet: " << hex(hasher.value());
  EXPECT_EQ(hex(hasher.value()), known->second) << GetParam();
}

TEST(NavigatorSignatures, BelongToNavigatorsUnderTest) {
  const auto calls = navigators_under_test();
  for (const auto& entry : known_signatures()) {
    EXPECT_NE(std::find(calls.begin(), calls.end(), entry.first), calls.end()) << entry.first;
  }
}

TEST(StaticPlanners, AreUnsupportedInAWorldThatMoves) {
  EXPECT_EQ(run({"astar"}, scenarios::Library().load("discs/open/1")).verdict, Verdict::unsupported);
}

}  // namespace
}  // namespace pathrace::testing
