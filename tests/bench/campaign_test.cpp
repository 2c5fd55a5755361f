// Campaign files: what they mean, and where they are wrong.
#include "bench/campaign.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "baselines/ompl_names.hpp"
#include "bench/roster.hpp"
#include "bench/trial_plan.hpp"
#include "core/error.hpp"

namespace pathrace::bench {
namespace {

constexpr const char* complete = R"([campaign]
name = "x"
seed = 7
repetitions = 3
[budget]
evaluations = 500
wall_s = 2.5
[[planner]]
name = "as"
params = { dead_end = "backtrack", ants = [20, 50], beta = 2.5 }
[[planner]]
name = "astar"
label = "A star"
[[scenarios]]
select = ["asr/*", "dense/10-10/1..2"]
[[scenarios]]
select = ["trap-u/10/1"]
budget = { checks = 1000 }
)";

TrialPlan plan_of_text(const std::string& text) {
  const scenarios::Library library;
  return plan_trials(parse_campaign(text, "x.toml"), library, roster());
}

std::string error_of(const std::string& text) {
  try {
    plan_of_text(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Campaign, ReadsEveryKey) {
  const Campaign campaign = parse_campaign(complete, "x.toml");
  EXPECT_EQ(campaign.name, "x");
  EXPECT_EQ(campaign.seed, 7U);
  EXPECT_EQ(campaign.repetitions, 3U);
  EXPECT_EQ(campaign.budget->evaluations, 500U);
  EXPECT_EQ(campaign.budget->wall_s, 2.5);
  ASSERT_EQ(campaign.planners.size(), 2U);
  EXPECT_EQ(campaign.planners[1].label, "A star");
  EXPECT_EQ(campaign.scenarios[1].budget->checks, 1000U);
}

TEST(Campaign, DotsAndBracketsInStringsAndCommentsAreNoDepth) {
  std::string text =
      "\xef\xbb\xbf# ............................ [[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[\r\n"
      "[campaign]\r\nname = \"a.b.c.d.e.f.g.h.i.j.k.l.m.n.o.p.q.r.s \\\" [[[[\"\r\n"
      "[[planner]]\r\nname = 'astar'\r\n[[scenarios]]\r\nselect = [\"\"\"asr/fig2\"\"\"]\r\n";
  EXPECT_EQ(parse_campaign(text, "x.toml").scenarios.at(0).select.at(0), "asr/fig2");
}

TEST(Campaign, SurvivesBeingPrintedAndReadAgain) {
  const scenarios::Library library;
  for (Campaign campaign :
       {parse_campaign(complete, "x.toml"), builtin_campaign("starter"), builtin_campaign("smoke")}) {
    leave_out_absent(campaign, roster());
    const Campaign again = parse_campaign(to_toml(campaign), "printed.toml");
    EXPECT_EQ(plan_trials(campaign, library, roster()).hash(), plan_trials(again, library, roster()).hash());
  }
}

// The roster of a build without OMPL.
Catalogue roster_without_ompl() {
  std::vector<PlannerCard> cards = roster().cards();
  std::erase_if(cards, [](const PlannerCard& card) { return card.kind == Kind::ompl; });
  std::vector<AbsentPlanner> absent;
  for (std::string& name : baselines::ompl_names()) absent.push_back({std::move(name), "OMPL"});
  return Catalogue(std::move(cards), std::move(absent));
}

TEST(Campaign, TheStarterRacesThreePlannersOfOmplOrLeavesThemOut) {
  const scenarios::Library library;
  const Catalogue catalogue = roster_without_ompl();
  Campaign campaign = builtin_campaign("starter");
  const std::size_t all = campaign.planners.size();
  EXPECT_THROW(plan_trials(campaign, library, catalogue), InputError);
  EXPECT_EQ(leave_out_absent(campaign, catalogue),
            (std::vector<std::string>{"ompl-rrt-connect", "ompl-rrt-star", "ompl-bit-star"}));
  EXPECT_EQ(campaign.planners.size(), all - 3);
  EXPECT_NO_THROW(plan_trials(campaign, library, catalogue));
}

TEST(Campaign, AListOfValuesIsOnePlannerPerValue) {
  const TrialPlan plan = plan_of_text(complete);
  ASSERT_EQ(plan.entrants.size(), 3U);
  EXPECT_EQ(plan.entrants[0].label, "as:ants=20,beta=2.5,dead_end=backtrack");
  EXPECT_EQ(plan.entrants[1].label, "as:beta=2.5,dead_end=backtrack");  // 50 ants are the default
  EXPECT_EQ(plan.entrants[2].label, "A star");
  EXPECT_EQ(plan.size(), 3U * 3 * (3 + 2 + 1));  // planners, repetitions, scenarios
}

TEST(Campaign, BudgetsOfScenariosReplaceTheCampaigns) {
  const TrialPlan plan = plan_of_text(complete);
  EXPECT_EQ(plan.trial(0).budget.evaluations, 500U);
  EXPECT_FALSE(plan.trial(plan.size() - 1).budget.evaluations.has_value());
  EXPECT_EQ(plan.trial(plan.size() - 1).budget.checks, 1000U);
}

TEST(Campaign, ExpandsInTheOrderScenarioPlannerRepetition) {
  const TrialPlan plan = plan_of_text(complete);
  EXPECT_EQ(plan.trial(0).key.repetition, 0U);
  EXPECT_EQ(plan.trial(2).key.repetition, 2U);
  EXPECT_EQ(plan.trial(3).entrant, 1U);
  EXPECT_EQ(plan.trial(9).scenario, 1U);
}

TEST(Campaign, AScenarioSelectedTwiceRunsOnce) {
  const std::string twice = R"(campaign = { name = "x" }
planner = [{ name = "astar" }]
scenarios = [{ select = ["asr/fig2", "asr/*"] }]
)";
  EXPECT_EQ(plan_of_text(twice).size(), 3U);
}

TEST(Campaign, KnowsWhichOfItsScenariosRepeatAQuestion) {
  const auto plan_of = [](const std::string& pattern) {
    return plan_of_text("campaign = { name = \"x\" }\nplanner = [{ name = \"greedy\" }]\n" +
                        ("scenarios = [{ select = [\"" + pattern + "\"] }]\n"));
  };
  const TrialPlan plan = plan_of("trap-comb/10/1..30");
  EXPECT_EQ(plan.scenarios.size(), 30U);
  EXPECT_EQ(plan.repeated, (std::vector<std::string>{"trap-comb/10/21 (trap-comb/10/14)",
                                                     "trap-comb/10/29 (trap-comb/10/7)"}));
  EXPECT_TRUE(plan_of("trap-comb/10/*").repeated.empty());
}

TEST(Campaign, WallLimitsDoNotNameATrial) {
  const std::string head =
      "campaign = { name = \"x\" }\nplanner = [{ name = \"astar\" }]\nscenarios = [{ select = [\"asr/fig2\"] "
      "}]\n";
  const TrialPlan a = plan_of_text(head + "budget = { checks = 10, wall_s = 1 }\n");
  const TrialPlan b = plan_of_text(head + "budget = { checks = 10, wall_s = 2 }\n");
  const TrialPlan c = plan_of_text(head + "budget = { checks = 11, wall_s = 1 }\n");
  EXPECT_EQ(a.trial(0).hash, b.trial(0).hash);
  EXPECT_NE(a.trial(0).hash, c.trial(0).hash);
}

struct Fault {
  const char* name;
  const char* text;
  std::vector<std::string> expected;
};

class CampaignFault : public ::testing::TestWithParam<Fault> {};

TEST_P(CampaignFault, IsNamedWithItsPlace) {
  const std::string message = error_of(GetParam().text);
  for (const std::string& part : GetParam().expected) {
    EXPECT_NE(message.find(part), std::string::npos) << "'" << part << "' is not in: " << message;
  }
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
}

constexpr const char* tail = "[[planner]]\nname = \"astar\"\n[[scenarios]]\nselect = [\"asr/fig2\"]\n";
const std::string head = "[campaign]\nname = \"x\"\n";
const std::string bad_budget = head + "[budget]\nevaluations = 0\n" + tail;
const std::string bad_wall = head + "[budget]\nwall_s = -1\n" + tail;
const std::string empty_budget = head + "[budget]\n" + tail;
const std::string bad_key = head + "[budgett]\nchecks = 1\n" + tail;
const std::string bad_seed = "[campaign]\nname = \"x\"\nseed = -4\n" + std::string(tail);
const std::string bad_type = "[campaign]\nname = \"x\"\nseed = \"one\"\n" + std::string(tail);
const std::string no_planner = head + "[[scenarios]]\nselect = [\"asr/fig2\"]\n";
const std::string bad_planner =
    head + "[[planner]]\nname = \"astra\"\n[[scenarios]]\nselect = [\"asr/fig2\"]\n";
const std::string bad_param =
    head + "[[planner]]\nname = \"as\"\nparams = { antz = 3 }\n[[scenarios]]\nselect = [\"asr/fig2\"]\n";
const std::string bad_value =
    head + "[[planner]]\nname = \"as\"\nparams = { ants = 0 }\n[[scenarios]]\nselect = [\"asr/fig2\"]\n";
const std::string bad_choice =
    head +
    "[[planner]]\nname = \"as\"\nparams = { dead_end = \"dye\" }\n[[scenarios]]\nselect = [\"asr/fig2\"]\n";
const std::string bad_select = head + "[[planner]]\nname = \"as\"\n[[scenarios]]\nselect = \"asr/fig2\"\n";
const std::string bad_glob = head + "[[planner]]\nname = \"as\"\n[[scenarios]]\nselect = [\"nothing-*/1\"]\n";
const std::string twins =
    head + "[[planner]]\nname = \"as\"\n[[planner]]\nname = \"as\"\n[[scenarios]]\nselect = [\"asr/fig2\"]\n";
const std::string slash = "[campaign]\nname = \"a/b\"\n" + std::string(tail);

const std::string crowd =
    "[campaign]\nname = \"b\"\nrepetitions = 1000000\n[[planner]]\nname = \"astar\"\n"
    "[[scenarios]]\nselect = [\"dense/20-20/1..1000\"]\n";
// Of which neither the scenarios nor the map are looked for.
const std::string planners =
    "[campaign]\nname = \"b\"\nrepetitions = 1000000\n[[planner]]\nname = \"as\"\n"
    "params = { ants = [1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11] }\n[[scenarios]]\nselect = [\"nothing-*/1\"]\n";
const std::string questions =
    "[campaign]\nname = \"b\"\nrepetitions = 11\n[[planner]]\nname = \"astar\"\n"
    "[[scenarios]]\nmap = \"none.map\"\nqueries = 1000000\n";
const std::string combinations = [] {
  std::string list = "[1";
  for (int i = 2; i <= 101; ++i) list += fmt::format(", {}", i);
  return head + "[[planner]]\nname = \"as\"\nparams = { alpha = " + list + "], beta = " + list + "] }\n" +
         "[[scenarios]]\nselect = [\"asr/fig2\"]\n";
}();
const std::string bell = "[campaign]\nname = \"a\\u0007\"\n" + std::string(tail);
const std::string red =
    head + "[[planner]]\nname = \"as\"\nlabel = \"\\u001b[31mRED\"\n[[scenarios]]\nselect = [\"asr/fig2\"]\n";
const std::string dotted = [] {
  std::string key = "x";
  for (int i = 0; i < 50'000; ++i) key += ".x";
  return head + key + " = 1\n";
}();
const std::string nested = head + "x = " + std::string(50'000, '[') + "\n";
// Strings hide brackets and dots, and the end of one that ends in four quotes hides nothing.
const std::string hidden = "a = { b = \"\"\"]\"\"\"\", c" + dotted.substr(head.size());

INSTANTIATE_TEST_SUITE_P(
    All, CampaignFault,
    ::testing::Values(
        Fault{"syntax", "[campaign\nname = 1\n", {"x.toml:1:", "x.toml:1:10"}},
        Fault{"empty", "", {"x.toml:", "[campaign]"}},
        Fault{"a_thousand_million_trials", crowd.c_str(), {"asks for 1000000000 trials", "10000000"}},
        Fault{"planners_of_too_many_trials", planners.c_str(), {"asks for 11000000 trials", "11 planners"}},
        Fault{"too_many_questions_on_a_map", questions.c_str(), {"11000000 trials", "1000000 scenarios"}},
        Fault{"too_many_combinations", combinations.c_str(), {"planner 'as'", "10000 combinations"}},
        Fault{"control_in_name", bell.c_str(), {"x.toml:2:", "a\\x07", "control characters"}},
        Fault{"control_in_label", red.c_str(), {"x.toml:5:", "\\x1b[31mRED"}},
        Fault{"dotted_keys", dotted.c_str(), {"x.toml:3:", "more than 16 parts"}},
        Fault{"nested_brackets", nested.c_str(), {"x.toml:3:", "more than 32 deep"}},
        Fault{"dotted_behind_a_string", hidden.c_str(), {"x.toml:1:", "more than 16 parts"}},
        Fault{"unknown_key", bad_key.c_str(), {"x.toml:3:", "budgett", "'budget'"}},
        Fault{"zero_budget", bad_budget.c_str(), {"x.toml:4:", "evaluations", "got 0"}},
        Fault{"negative_wall", bad_wall.c_str(), {"x.toml:4:", "wall_s"}},
        Fault{"empty_budget", empty_budget.c_str(), {"x.toml:3:", "budget"}},
        Fault{"negative_seed", bad_seed.c_str(), {"x.toml:3:", "seed", "-4"}},
        Fault{"text_for_number", bad_type.c_str(), {"x.toml:3:", "seed", "integer"}},
        Fault{"no_planner", no_planner.c_str(), {"x.toml:", "[[planner]]"}},
        Fault{"unknown_planner", bad_planner.c_str(), {"astra", "'astar'"}},
        Fault{"unknown_parameter", bad_param.c_str(), {"antz", "'ants'"}},
        Fault{"value_out_of_range", bad_value.c_str(), {"ants", "1..100000", "'0'"}},
        Fault{"unknown_choice", bad_choice.c_str(), {"dye", "'die'"}},
        Fault{"select_is_no_list", bad_select.c_str(), {"x.toml:6:", "select"}},
        Fault{"glob_without_match", bad_glob.c_str(), {"nothing-*/1"}},
        Fault{"two_of_a_name", twins.c_str(), {"two planners", "'as'"}},
        Fault{"name_with_a_slash", slash.c_str(), {"x.toml:2:", "a/b"}}),
    [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace pathrace::bench
