// One trial: every verdict, brought about by a planner that misbehaves in just that way.
#include "bench/trial.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <new>
#include <stdexcept>

#include "core/checkpoint.hpp"
#include "core/error.hpp"
#include "tests/support/trials.hpp"

namespace pathrace::bench {
namespace {

using testing::grid_of;
using testing::scenario_of;

const Scenario& open_square() {
  static const Scenario scenario = scenario_of({grid_of({"..", ".."}), {0, 0}, {1, 1}});
  return scenario;
}

TrialRecord trial_of(PlanFunction plan, Budget budget = {}, bool deterministic = true,
                     const Scenario& scenario = open_square(), Track track = Track::lattice,
                     bool complete_search = false) {
  PlannerCard card;
  card.name = "test";
  card.track = track;
  card.deterministic = deterministic;
  card.complete_search = complete_search;
  card = without_parameters(std::move(card), unprepared(std::move(plan)));
  const Entrant entrant{&card, {}, "test"};
  const auto executor = make_executor("serial", 1);
  return run_trial(entrant, scenario, Referee(scenario.terrain), budget, Stream(1), *executor);
}

TrialRecord trial_with_set_up(const std::function<void()>& set_up, const Budget& budget) {
  PlannerCard card;
  card.name = "test";
  card = without_parameters(std::move(card), [set_up](const Terrain& terrain) {
    set_up();
    return unprepared([](const Problem&, Context&) -> Answer { return std::nullopt; })(terrain);
  });
  const Entrant entrant{&card, {}, "test"};
  const auto executor = make_executor("serial", 1);
  const Scenario& scenario = open_square();
  return run_trial(entrant, scenario, Referee(scenario.terrain), budget, Stream(1), *executor);
}

Answer right_answer(const Problem&, Context&) {
  return lattice_path({{0, 0}, {1, 1}});
}

TEST(Trial, SetUpThatRunsOutOfTimeIsCutAtACheckpoint) {
  Budget budget;
  budget.wall_s = 0;
  const TrialRecord record = trial_with_set_up([] { checkpoint(); }, budget);
  EXPECT_EQ(record.verdict, Verdict::budget);
  EXPECT_TRUE(record.timed);
  EXPECT_FALSE(record.answer.has_value());
  EXPECT_EQ(record.work, Work{});
}

TEST(Trial, EachPlannerIsOverAtOnceWithoutTime) {
  Budget budget;
  budget.wall_s = 0;
  for (const std::string& call : testing::calls_under_test()) {
    const TrialRecord record = testing::run({call, budget}, open_square());
    EXPECT_EQ(record.verdict, Verdict::budget) << call << ": " << record.note;
    EXPECT_TRUE(record.timed) << call;
  }
}

TEST(Trial, IsNoRecordOnceTheProcessIsAskedToStop) {
  struct AskToStop {
    AskToStop() { stop_requested.store(true); }
    ~AskToStop() { stop_requested.store(false); }
  };
  const auto set_up = [] {
    const AskToStop asked;
    checkpoint();
  };
  EXPECT_THROW(trial_with_set_up(set_up, {}), Interrupted);
  const auto told = [](const Problem& problem, Context& context) {
    const AskToStop asked;
    return context.meter.exhausted() ? std::nullopt : right_answer(problem, context);
  };
  EXPECT_THROW(trial_of(told), Interrupted);
  const auto untold = [](const Problem& problem, Context& context) {
    const AskToStop asked;
    return right_answer(problem, context);
  };
  EXPECT_EQ(trial_of(untold).verdict, Verdict::solved);
}

TEST(Trial, ALegalPathIsSolvedAndMeasured) {
  const TrialRecord record = trial_of(right_answer);
  EXPECT_EQ(record.verdict, Verdict::solved);
  EXPECT_EQ(record.metrics->lattice, (LatticeLength{0, 1}));
}

TEST(Trial, AnIllegalPathIsInvalidAndSaysWhy) {
  const TrialRecord record = trial_of([](const Problem&, Context&) {
    return lattice_path({{0, 0}, {1, 0}});
  });
  EXPECT_EQ(record.verdict, Verdict::invalid);
  EXPECT_NE(record.note.find("goal"), std::string::npos);
  EXPECT_FALSE(record.metrics.has_value());
}

TEST(Trial, APathOnAnotherTrackIsInvalid) {
  const TrialRecord record = trial_of([](const Problem&, Context&) -> Answer {
    return Path{Track::any_angle, {{0, 0}, {1, 1}}};
  });
  EXPECT_EQ(record.verdict, Verdict::invalid);
}

TEST(Trial, ALegalPathThatBeatsTheProofIsInvalidAndSaysBoth) {
  Scenario scenario = open_square();
  scenario.optimum = {true, LatticeLength{2, 0}};  // a wrong proof: the diagonal is legal and shorter
  scenario.any_angle_optimum = {true, 2};
  const TrialRecord on_cells = trial_of(right_answer, {}, true, scenario);
  EXPECT_EQ(on_cells.verdict, Verdict::invalid);
  EXPECT_EQ(on_cells.note, "a legal path of 1.4142135623730951 is shorter than the proven optimum 2");
  EXPECT_FALSE(on_cells.metrics.has_value());
  const auto straight = [](const Problem&, Context&) -> Answer {
    return Path{Track::any_angle, {{0, 0}, {1, 1}}};
  };
  const TrialRecord at_any_angle = trial_of(straight, {}, true, scenario, Track::any_angle);
  EXPECT_EQ(at_any_angle.verdict, Verdict::invalid);
  EXPECT_EQ(at_any_angle.note, on_cells.note);

  scenario.optimum.length = LatticeLength{0, 1};
  EXPECT_EQ(trial_of(right_answer, {}, true, scenario).verdict, Verdict::solved);
}

TEST(Trial, SpendingMoreThanTheBudgetIsInvalidHoweverGoodThePath) {
  Budget budget;
  budget.evaluations = 3;
  const TrialRecord record = trial_of(
      [](const Problem& problem, Context& context) {
        context.meter.spend_evaluations(4);
        return right_answer(problem, context);
      },
      budget);
  EXPECT_EQ(record.verdict, Verdict::invalid);
  EXPECT_NE(record.note.find("4 evaluations"), std::string::npos);
}

// Three ways to end without an answer.
Answer give_up(const Problem&, Context&) {
  return std::nullopt;
}
Answer spend_two_checks(const Problem&, Context& context) {
  context.meter.spend_checks(2);
  return std::nullopt;
}
Answer claim_no_way(const Problem& problem, Context& context) {
  context.meter.conclude();
  return spend_two_checks(problem, context);
}

TrialRecord empty_trial_of(PlanFunction plan, bool complete, const Scenario& scenario = open_square(),
                           Track track = Track::lattice) {
  Budget budget;
  budget.checks = 2;
  return trial_of(std::move(plan), budget, true, scenario, track, complete);
}

TEST(Trial, AnEmptyAnswerIsNoPathOnlyAsAProof) {
  EXPECT_EQ(empty_trial_of(give_up, false).verdict, Verdict::gave_up);
  EXPECT_EQ(empty_trial_of(spend_two_checks, false).verdict, Verdict::budget);
  EXPECT_EQ(empty_trial_of(claim_no_way, false).verdict, Verdict::no_path);
  EXPECT_EQ(empty_trial_of(give_up, true).verdict, Verdict::no_path);
  EXPECT_EQ(empty_trial_of(spend_two_checks, true).verdict, Verdict::budget);
  EXPECT_EQ(empty_trial_of(claim_no_way, true).verdict, Verdict::no_path);
}

TEST(Trial, WhereThereIsProvablyNoWayEveryEmptyAnswerAgrees) {
  Scenario scenario = open_square();
  scenario.optimum.proven = true;
  EXPECT_EQ(empty_trial_of(give_up, false, scenario).verdict, Verdict::no_path);
  EXPECT_EQ(empty_trial_of(claim_no_way, true, scenario).verdict, Verdict::no_path);
  EXPECT_EQ(empty_trial_of(spend_two_checks, false, scenario).verdict, Verdict::budget);
  // The proof counts on its own track.
  EXPECT_EQ(empty_trial_of(give_up, false, scenario, Track::any_angle).verdict, Verdict::gave_up);
}

TEST(Trial, AClaimOfNoWayAgainstAProvenOptimumIsNotBelieved) {
  Scenario scenario = open_square();
  scenario.optimum = {true, LatticeLength{0, 1}};
  EXPECT_EQ(empty_trial_of(give_up, false, scenario).verdict, Verdict::gave_up);
  EXPECT_EQ(empty_trial_of(give_up, false, scenario).note, "");
  EXPECT_EQ(empty_trial_of(spend_two_checks, true, scenario).verdict, Verdict::budget);

  const std::string note = "test claims that there is no way; the proven optimum is 1.4142135623730951";
  const TrialRecord doubtful = empty_trial_of(claim_no_way, false, scenario);
  EXPECT_EQ(doubtful.verdict, Verdict::gave_up);
  EXPECT_EQ(doubtful.note, note);
  for (const auto plan : {give_up, claim_no_way}) {
    const TrialRecord wrong = empty_trial_of(plan, true, scenario);
    EXPECT_EQ(wrong.verdict, Verdict::invalid);
    EXPECT_EQ(wrong.note, note);
  }
}

TEST(Trial, WhatAPlannerThrowsBecomesAVerdict) {
  const auto verdict_of = [](auto exception) {
    return trial_of([exception](const Problem&, Context&) -> Answer { throw exception; });
  };
  EXPECT_EQ(verdict_of(std::bad_alloc()).verdict, Verdict::out_of_memory);
  EXPECT_EQ(verdict_of(Unsupported("only the rule four")).verdict, Verdict::unsupported);
  EXPECT_EQ(verdict_of(Unsupported("only the rule four")).note, "only the rule four");
  EXPECT_EQ(verdict_of(InvalidScenario("no grid")).verdict, Verdict::bad_scenario);
  EXPECT_EQ(verdict_of(std::runtime_error("index 7")).verdict, Verdict::crashed);
  EXPECT_EQ(verdict_of(42).verdict, Verdict::crashed);
}

TEST(Trial, AWallLimitMarksTheRecordAsTimed) {
  Budget budget;
  budget.wall_s = 1e-9;
  const TrialRecord record = trial_of(
      [](const Problem&, Context& context) {
        while (!context.meter.exhausted()) {
        }
        return Answer{};
      },
      budget);
  EXPECT_TRUE(record.timed);
  EXPECT_EQ(record.verdict, Verdict::budget);
}

TEST(Trial, AnAnswerThatNeedNotRepeatStaysOutsideDigestsLikeATimedOne) {
  const TrialRecord record = trial_of(right_answer, {}, false);
  EXPECT_EQ(record.verdict, Verdict::solved);
  EXPECT_TRUE(record.timed);
  EXPECT_FALSE(trial_of(right_answer).timed);
}

}  // namespace
}  // namespace pathrace::bench
