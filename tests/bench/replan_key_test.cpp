// The key of a trial of replan(PLANNER) stands for the version of the planner inside, too.
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include "baselines/navigators/replan.hpp"
#include "bench/roster.hpp"
#include "bench/trial_plan.hpp"

namespace pathrace::bench {
namespace {

constexpr const char* campaign = R"([campaign]
name = "x"
[[planner]]
name = 'replan(astar)'
[[planner]]
name = 'replan(greedy)'
[[planner]]
name = "straight"
[[scenarios]]
select = ["discs/open/1"]
)";

// The roster with other versions of A* and replan.
Catalogue roster_with(int astar, int replan) {
  std::vector<PlannerCard> maps;
  std::vector<PlannerCard> all;
  for (PlannerCard card : roster().cards()) {
    if (card.name == "astar") card.version = astar;
    if (!card.navigates()) maps.push_back(card);
    if (card.name != "replan") all.push_back(std::move(card));
  }
  all.push_back(baselines::replan_card(std::make_shared<const Catalogue>(std::move(maps))));
  all.back().version = replan;
  return Catalogue(std::move(all));
}

std::map<std::string, std::uint64_t> keys(const Catalogue& catalogue) {
  const TrialPlan plan = plan_trials(parse_campaign(campaign, "x.toml"), scenarios::Library(), catalogue);
  std::map<std::string, std::uint64_t> keys;
  for (std::size_t i = 0; i < plan.size(); ++i) {
    const Trial trial = plan.trial(i);
    keys[plan.entrants[trial.entrant].label] = trial.hash;
  }
  return keys;
}

TEST(ReplanKey, ChangesWithTheVersionOfThePlannerInside) {
  const auto before = keys(roster_with(2, 1));
  const auto after = keys(roster_with(3, 1));
  EXPECT_NE(after.at("replan(astar)"), before.at("replan(astar)"));
  EXPECT_EQ(after.at("replan(greedy)"), before.at("replan(greedy)"));
  EXPECT_EQ(after.at("straight"), before.at("straight"));
}

TEST(ReplanKey, ChangesWithItsOwnVersionWhateverIsInside) {
  const auto before = keys(roster_with(2, 1));
  const auto after = keys(roster_with(2, 2));
  EXPECT_NE(after.at("replan(astar)"), before.at("replan(astar)"));
  EXPECT_NE(after.at("replan(greedy)"), before.at("replan(greedy)"));
  EXPECT_EQ(after.at("straight"), before.at("straight"));
}

TEST(ReplanKey, TheVersionOfACallCountsTheOneInside) {
  const Catalogue catalogue = roster_with(4, 3);
  EXPECT_EQ(catalogue.enter(parse_call("astar")).version(), 4);
  EXPECT_EQ(catalogue.enter(parse_call("replan(greedy)")).version(), 3);  // greedy has version 1
  EXPECT_EQ(catalogue.enter(parse_call("replan(astar)")).version(), 6);
}

TEST(ReplanKey, DrawsRandomNumbersWhenItsPlannerDoes) {
  const auto draws = [](const char* call) { return roster().enter(parse_call(call)).draws(); };
  EXPECT_FALSE(draws("replan"));
  EXPECT_FALSE(draws("replan(jps)"));
  EXPECT_TRUE(draws("replan(as:ants=10)"));
}

}  // namespace
}  // namespace pathrace::bench
