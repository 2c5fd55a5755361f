// Parameters that contradict each other are refused before anything runs, whichever way they come in.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/bench/command_line.hpp"

namespace pathrace::bench {
namespace {

using testing::ScratchFolder;

const char* const campaign = R"([campaign]
name = "contradiction"
[budget]
evaluations = 300
[[planner]]
name = "astar"
[[planner]]
name = "pso"
params = { waypoints_min = 10, waypoints_max = 3 }
[[scenarios]]
select = ["trap-u/20/1"]
)";

const std::vector<std::string> words = {"planner 'pso'", "waypoints_min=10", "waypoints_max=3",
                                        "waypoints_min must be at most waypoints_max"};

TEST(Contradictions, ACampaignIsRefusedByRunAndByCheck) {
  const ScratchFolder scratch;
  const std::string file = scratch.file("campaign.toml", campaign);
  expect_refusal(pathrace({"scenarios", "check", file}), words);
  expect_refusal(pathrace({"run", file, "--out", scratch / "out"}), words);
  expect_refusal(pathrace({"run", file, "--out", scratch / "out", "--dry-run"}), words);
}

TEST(Contradictions, APlanIsRefused) {
  expect_refusal(pathrace({"plan", "--scenario", "trap-u/20/1", "--planner",
                           "pso:waypoints_min=10,waypoints_max=3", "--evaluations", "300"}),
                 words);
  expect_refusal(pathrace({"plan", "--scenario", "trap-u/20/1", "--planner", "pso:waypoints_max=1"}),
                 {"waypoints_min=3", "waypoints_max=1"});
  expect_refusal(pathrace({"plan", "--scenario", "discs/ring/1", "--planner",
                           "replan(xie2010:repair=local_search,insertion=blind)"}),
                 {"repair=local_search", "insertion=blind", "needs insertion = general"});
  expect_refusal(pathrace({"plan", "--scenario", "trap-u/20/1", "--planner",
                           "pu2022:teaching=parameters,ants=5,students=5"}),
                 {"ants=5", "students=5", "more ants than students"});
}

TEST(Contradictions, ADescriptionShowsTheConditions) {
  const std::string rule = "waypoints_min must be at most waypoints_max";
  const testing::Finished text = pathrace({"planners", "describe", "pso"});
  EXPECT_NE(text.out.find("Conditions\n  " + rule + "\n"), std::string::npos) << text.out;
  const auto json = nlohmann::json::parse(pathrace({"planners", "describe", "pso", "--json"}).out);
  ASSERT_EQ(json["conditions"].size(), 1U);
  EXPECT_EQ(json["conditions"][0]["rule"], rule);
  EXPECT_EQ(json["conditions"][0]["parameters"],
            (std::vector<std::string>{"waypoints_min", "waypoints_max"}));
  EXPECT_EQ(pathrace({"planners", "describe", "as"}).out.find("Conditions"), std::string::npos);
}

}  // namespace
}  // namespace pathrace::bench
