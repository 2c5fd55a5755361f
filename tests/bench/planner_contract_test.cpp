// The contract of planners: what holds for every one of them, whatever it is meant to be good at.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/maps.hpp"
#include "tests/support/oracle.hpp"
#include "tests/support/trials.hpp"

namespace pathrace::algorithms {

PlannerCard wander_card();  // the planner that README.md shows

}  // namespace pathrace::algorithms

namespace pathrace::testing {
namespace {

const Catalogue& planners() {
  static const Catalogue all = [] {
    std::vector<PlannerCard> cards = bench::roster().cards();
    cards.push_back(algorithms::wander_card());
    return Catalogue(std::move(cards));
  }();
  return all;
}

TrialRecord race(const TrialSetting& setting, const Scenario& scenario) {
  return bench::run_trial(planners().enter(parse_call(setting.call)), scenario, Referee(scenario.terrain),
                          setting.budget, root_stream(setting.seed, scenario.id, 0),
                          *bench::make_executor(setting.backend, setting.threads));
}

Budget evaluations(std::uint64_t count) {
  Budget budget;
  budget.evaluations = count;
  return budget;
}

Budget small_budget() {
  Budget budget;
  budget.evaluations = 60;
  budget.checks = 20000;
  return budget;
}

void expect_no_answer(const TrialRecord& record) {
  EXPECT_TRUE(record.verdict == Verdict::no_path || record.verdict == Verdict::budget ||
              record.verdict == Verdict::gave_up)
      << name(record.verdict);
}

class PlannerContract : public ::testing::TestWithParam<std::string> {
 protected:
  TrialRecord trial(const Scenario& scenario, const Budget& budget = small_budget()) const {
    return race({GetParam(), budget}, scenario);
  }
};

TEST_P(PlannerContract, AnswersAreLegalUnderEveryMoveRuleAndNeverBelowTheOptimum) {
  for (std::uint64_t i = 0; i < 40; ++i) {
    const Question question = random_question(Stream(7).fork(i), 9, 0.35);
    for (const MoveRule rule : all_rules) {
      const Scenario scenario = scenario_of(question, rule);
      const TrialRecord record = trial(scenario);
      const auto optimum = oracle_optimum(question.grid, rule, question.start, question.goal);
      ASSERT_NE(record.verdict, Verdict::invalid) << i << ' ' << name(rule) << ": " << record.note;
      ASSERT_NE(record.verdict, Verdict::crashed) << i << ' ' << name(rule) << ": " << record.note;
      if (record.verdict != Verdict::solved) continue;
      ASSERT_TRUE(optimum.has_value()) << i << ' ' << name(rule);
      if (record.answer->track == Track::any_angle) continue;  // races against another optimum
      ASSERT_TRUE(record.metrics->lattice.has_value());
      EXPECT_FALSE(*record.metrics->lattice < *optimum) << i << ' ' << name(rule);
    }
  }
}

TEST_P(PlannerContract, StartOnTheGoalIsSolvedWithLengthZero) {
  for (const std::vector<std::string>& rows : {std::vector<std::string>{"."}, {"...", ".#.", "..."}}) {
    const Question question{grid_of(rows), {0, 0}, {0, 0}};
    const TrialRecord record = trial(scenario_of(question));
    ASSERT_EQ(record.verdict, Verdict::solved) << record.note;
    EXPECT_EQ(record.metrics->length, 0);
    EXPECT_EQ(record.answer->points.size(), 1U);
    EXPECT_GE(record.work.evaluations, 1U);
  }
}

TEST_P(PlannerContract, WithoutAWayThereIsNoAnswer) {
  const Question question{grid_of({"..#..", "..#..", "..#.."}), {0, 1}, {4, 1}};
  const TrialRecord record = trial(scenario_of(question));
  expect_no_answer(record);
  EXPECT_FALSE(record.answer.has_value());
  Scenario proven = scenario_of(question);
  proven.optimum = {true, std::nullopt};
  proven.any_angle_optimum = {true, std::nullopt};
  EXPECT_NE(trial(proven).verdict, Verdict::gave_up);
}

TEST_P(PlannerContract, NothingIsCalledNoPathWhereThereIsAWay) {
  for (std::uint64_t i = 0; i < 12; ++i) {
    const Question question = random_question(Stream(17).fork(i), 9, 0.4);
    if (!oracle_optimum(question.grid, MoveRule::strict, question.start, question.goal)) continue;
    Budget budget = small_budget();
    for (const std::uint64_t limit : {1U, 3U, 60U}) {
      budget.evaluations = limit;
      EXPECT_NE(trial(scenario_of(question), budget).verdict, Verdict::no_path) << i << ", " << limit;
    }
  }
}

TEST_P(PlannerContract, AStartWithoutAStepHasNoAnswer) {
  const Question question{grid_of({".#.", "##.", "..."}), {0, 0}, {2, 2}};
  const TrialRecord record = trial(scenario_of(question));
  expect_no_answer(record);
}

TEST_P(PlannerContract, ABudgetIsNeverExceededWhateverItLimits) {
  const Scenario scenario = scenario_of(random_question(Stream(3), 12, 0.2));
  for (const std::uint64_t limit : {1U, 2U, 7U, 33U, 500U}) {
    Budget budget;
    for (auto member : {&Budget::evaluations, &Budget::iterations, &Budget::checks}) {
      budget = {};
      budget.*member = limit;
      budget.evaluations = budget.evaluations.value_or(200);
      const TrialRecord record = trial(scenario, budget);
      EXPECT_NE(record.verdict, Verdict::invalid) << to_string(budget) << ": " << record.note;
      EXPECT_LE(record.work.evaluations, *budget.evaluations) << to_string(budget);
      if (budget.iterations) {
        EXPECT_LE(record.work.iterations, limit) << to_string(budget);
      }
      if (budget.checks) {
        EXPECT_LE(record.work.checks, limit) << to_string(budget);
      }
    }
  }
}

TEST_P(PlannerContract, TheTraceStrictlyFallsAndItsWorkNeverDoes) {
  const Scenario scenario = scenario_of(random_question(Stream(11), 14, 0.15));
  const TrialRecord record = trial(scenario, evaluations(300));
  for (std::size_t i = 1; i < record.trace.size(); ++i) {
    EXPECT_LT(record.trace[i].cost, record.trace[i - 1].cost);
    EXPECT_GE(record.trace[i].work.evaluations, record.trace[i - 1].work.evaluations);
    EXPECT_GE(record.trace[i].work.checks, record.trace[i - 1].work.checks);
  }
}

TEST_P(PlannerContract, TheSameSeedGivesTheSameRecordOnEveryExecutorAndNumberOfThreads) {
  for (std::uint64_t i = 0; i < 4; ++i) {
    const Scenario scenario = scenario_of(random_question(Stream(23).fork(i), 16, 0.25));
    Budget tight = small_budget();
    tight.checks = 900;  // cuts ants in the middle of a batch
    for (const Budget& budget : {small_budget(), tight}) {
      const std::uint64_t expected = digest(race({GetParam(), budget}, scenario));
      for (const std::string& backend : executors_under_test()) {
        for (const int threads : {1, 2, 4}) {
          EXPECT_EQ(digest(race({GetParam(), budget, backend, threads}, scenario)), expected)
              << backend << " with " << threads << " threads";
        }
      }
    }
  }
}

TEST_P(PlannerContract, APreparedPlannerKeepsNothingThatChangesALaterAnswer) {
  const Question question = random_question(Stream(29), 14, 0.2);
  const Scenario scenario = scenario_of(question);
  const Entrant entrant = planners().enter(parse_call(GetParam()));
  const std::unique_ptr<Executor> executor = bench::make_executor("serial", 1);
  const auto answer = [&](MapPlanner& planner, Cell start, Cell goal) {
    Meter meter(small_budget());
    Context context{Stream(5), *executor, meter};
    return planner.plan(start, goal, context);
  };
  const std::unique_ptr<MapPlanner> used = entrant.card->make(entrant.values)(scenario.terrain);
  for (const Cell cell : free_cells_of(question.grid)) answer(*used, cell, question.goal);
  const std::unique_ptr<MapPlanner> fresh = entrant.card->make(entrant.values)(scenario.terrain);
  EXPECT_EQ(answer(*used, question.start, question.goal), answer(*fresh, question.start, question.goal));
}

std::string test_name(const ::testing::TestParamInfo<std::string>& info) {
  std::string text = info.param;
  std::replace_if(
      text.begin(), text.end(), [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
  return text;
}

INSTANTIATE_TEST_SUITE_P(All, PlannerContract, ::testing::ValuesIn(calls_under_test()), test_name);
INSTANTIATE_TEST_SUITE_P(OfTheReadme, PlannerContract, ::testing::Values("wander"), test_name);

TEST(Roster, APlannerThatDrawsNothingRepeatsWhateverTheSeed) {
  const Scenario scenario = scenario_of(random_question(Stream(5), 20, 0.2));
  std::size_t tested = 0;
  for (const std::string& call : calls_under_test()) {
    if (planners().enter(parse_call(call)).draws()) continue;
    ++tested;
    EXPECT_EQ(digest(race({call, small_budget(), "serial", 1, 1}, scenario)),
              digest(race({call, small_budget(), "serial", 1, 2}, scenario)))
        << call;
  }
  EXPECT_GE(tested, 5U);  // exact search and greedy at least
}

TEST(Roster, EveryCardIsComplete) {
  for (const PlannerCard& card : bench::roster().cards()) {
    EXPECT_FALSE(card.summary.empty()) << card.name;
    EXPECT_FALSE(card.source.empty()) << card.name;
    EXPECT_GE(card.version, 1) << card.name;
    for (const ParameterCard& parameter : card.parameters) {
      EXPECT_FALSE(parameter.meaning.empty()) << card.name << ':' << parameter.name;
      EXPECT_FALSE(parameter.range.empty()) << card.name << ':' << parameter.name;
      EXPECT_NO_THROW(card.complete({{parameter.name, parameter.default_value}}))
          << card.name << ':' << parameter.name;
      EXPECT_THROW(card.complete({{parameter.name, "no such value"}}), InputError)
          << card.name << ':' << parameter.name;
    }
  }
}

TEST(Roster, NamesAreUnique) {
  const auto& cards = bench::roster().cards();
  for (std::size_t i = 1; i < cards.size(); ++i) EXPECT_LT(cards[i - 1].name, cards[i].name);
}

}  // namespace
}  // namespace pathrace::testing
