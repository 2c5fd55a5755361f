// The expected time of a campaign: what holds whatever the clock says.
#include "bench/estimate.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "bench/roster.hpp"

namespace pathrace::bench {
namespace {

TrialPlan plan_of(const std::string& toml) {
  return plan_trials(parse_campaign(toml, "test"), scenarios::Library(), roster());
}

std::vector<std::size_t> all_of(const TrialPlan& plan) {
  std::vector<std::size_t> indices(plan.trials.size());
  std::iota(indices.begin(), indices.end(), std::size_t{0});
  return indices;
}

const char* const two_planners_two_sizes = R"(
[campaign]
name = "x"
repetitions = 2
[budget]
evaluations = 50
[[planner]]
name = "astar"
[[planner]]
name = "as"
[[scenarios]]
select = ["dense/10-20/1..3", "dense/60-20/1..3"]
)";

TEST(Estimate, EveryTrialGetsItsShareOfTheWholeTime) {
  const TrialPlan plan = plan_of(two_planners_two_sizes);
  RunOptions one_job;
  one_job.backend = "serial";
  const Estimate estimate = estimate_time(plan, all_of(plan), one_job);
  ASSERT_EQ(estimate.trial_s.size(), plan.trials.size());
  for (const double trial_s : estimate.trial_s) EXPECT_GT(trial_s, 0);
  EXPECT_NEAR(std::accumulate(estimate.trial_s.begin(), estimate.trial_s.end(), 0.0), estimate.wall_s,
              1e-9 * estimate.wall_s);
}

TEST(Estimate, TrialsOfOnePlannerOnMapsOfOneSizeAreExpectedToTakeTheSame) {
  const TrialPlan plan = plan_of(two_planners_two_sizes);
  const Estimate estimate = estimate_time(plan, all_of(plan), RunOptions{});
  for (std::size_t a = 0; a < plan.trials.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      const auto group = [&](std::size_t t) {
        return std::pair(plan.trials[t].entrant, plan.scenarios[plan.trials[t].scenario].grid().width());
      };
      if (group(a) == group(b)) {
        EXPECT_EQ(estimate.trial_s[a], estimate.trial_s[b]);
      }
    }
  }
}

TEST(Estimate, RestsOnThreeTrialsOfEachGroupWhereThereIsTime) {
  const TrialPlan plan = plan_of(two_planners_two_sizes);  // four groups of six trials, milliseconds each
  EXPECT_LE(estimate_time(plan, all_of(plan), RunOptions{}).pilots, 12U);
  EXPECT_GE(estimate_time(plan, all_of(plan), RunOptions{}).pilots, 4U);
  EXPECT_LE(estimate_time(plan, {0}, RunOptions{}).pilots, 1U);  // a group of one trial is asked once
}

TEST(Estimate, AnEmptyListTakesNoTime) {
  const TrialPlan plan = plan_of(two_planners_two_sizes);
  const Estimate estimate = estimate_time(plan, {}, RunOptions{});
  EXPECT_EQ(estimate.wall_s, 0);
  EXPECT_TRUE(estimate.trial_s.empty());
}

}  // namespace
}  // namespace pathrace::bench
