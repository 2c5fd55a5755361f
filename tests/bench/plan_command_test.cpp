// `pathrace plan`: one trial, its JSON, its picture and its trace.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/bench/command_line.hpp"

namespace pathrace::bench {
namespace {

using testing::Finished;
using testing::ScratchFolder;
using Json = nlohmann::json;

TEST(Plan, PrintsOneJsonObjectWithTheContractsKeys) {
  const Finished plan = pathrace({"plan", "--scenario", "asr/fig5", "--planner", "astar", "--json"});
  ASSERT_EQ(plan.exit_code, 0) << plan.err;
  EXPECT_TRUE(plan.err.empty()) << plan.err;
  const Json object = Json::parse(plan.out);
  for (const char* key :
       {"scenario", "planner", "verdict", "track", "rule", "length", "optimum", "gap", "turns", "cells",
        "evaluations", "iterations", "checks", "digest", "backend", "threads", "threads_used", "wall_s"}) {
    EXPECT_TRUE(object.contains(key)) << key;
  }
  EXPECT_EQ(object["verdict"], "solved");
  EXPECT_EQ(object["gap"], 0);
  EXPECT_NEAR(object["length"].get<double>(), 6.2426, 1e-4);
  EXPECT_EQ(object["cells"].front(), Json({0, 0}));
  EXPECT_EQ(object["cells"].back(), Json({4, 4}));
}

TEST(Plan, StartOnTheGoalAndNoWayAreAnswersNotErrors) {
  const ScratchFolder scratch;
  const std::string map = scratch.file("wall.map", "type octile\nheight 1\nwidth 3\nmap\n.@.\n");
  const auto plan = [&](const std::string& goal, const std::string& planner) {
    const Finished finished =
        pathrace({"plan", "--map", map, "--start", "0,0", "--goal", goal, "--planner", planner, "--json"});
    EXPECT_EQ(finished.exit_code, 0) << finished.err;
    return Json::parse(finished.out);
  };
  for (const char* planner : {"astar", "dijkstra", "greedy", "as", "random-walk"}) {
    const Json here = plan("0,0", planner);
    EXPECT_EQ(here["verdict"], "solved") << planner;
    EXPECT_EQ(here["length"], 0) << planner;
    EXPECT_EQ(here["gap"], 0) << planner;
  }
  const Json nowhere = plan("2,0", "astar");
  EXPECT_EQ(nowhere["verdict"], "no_path");
  EXPECT_TRUE(nowhere["length"].is_null());
  EXPECT_TRUE(nowhere["cells"].is_null());
}

TEST(Plan, FailsWhenThePlannerDidNotWhenThereIsNoAnswer) {
  const auto plan = [](const std::string& scenario, const std::string& planner) {
    const Finished finished = pathrace({"plan", "--scenario", scenario, "--planner", planner, "--json"});
    return std::pair(Json::parse(finished.out)["verdict"].get<std::string>(), finished.exit_code);
  };
  using Outcome = std::pair<std::string, int>;
  EXPECT_EQ(plan("trap-u/20/1", "astar"), Outcome("solved", 0));
  EXPECT_EQ(plan("trap-u/20/1", "greedy"), Outcome("gave_up", 0));
  EXPECT_EQ(plan("trap-u/20/1", "straight"), Outcome("unsupported", 0));
  EXPECT_EQ(plan("discs/dense/1", "straight"), Outcome("invalid", 1));  // it drives into discs
}

TEST(Plan, APictureSaysHowATrialWithoutAnAnswerEnded) {
  const ScratchFolder scratch;
  ASSERT_EQ(pathrace({"plan", "--scenario", "trap-u/20/1", "--planner", "greedy", "--svg", scratch / "a.svg"})
                .exit_code,
            0);
  std::ifstream svg(scratch / "a.svg");
  std::stringstream text;
  text << svg.rdbuf();
  EXPECT_NE(text.str().find(">greedy on trap-u/20/1: gave up<"), std::string::npos);
  EXPECT_NE(text.str().find(">gave up  "), std::string::npos);
  EXPECT_EQ(text.str().find("no path"), std::string::npos);
}

TEST(Plan, RepeatsARowOfACampaign) {
  const ScratchFolder scratch;
  const std::string campaign = scratch.file("one.toml", R"([campaign]
name = "one"
seed = 5
repetitions = 3
[budget]
evaluations = 100
[[planner]]
name = "as"
[[scenarios]]
select = ["dense/20-20/3"]
)");
  ASSERT_EQ(pathrace({"run", campaign, "--out", scratch / "run", "--backend", "threads"}).exit_code, 0);
  std::ifstream trials(scratch / "run/trials.csv");
  std::stringstream text;
  text << trials.rdbuf();
  for (const char* repetition : {"0", "1", "2"}) {
    const Finished plan =
        pathrace({"plan", "--scenario", "dense/20-20/3", "--planner", "as", "--seed", "5", "--repetition",
                  repetition, "--evaluations", "100", "--json", "--backend", "threads"});
    const std::string digest = Json::parse(plan.out)["digest"];
    EXPECT_NE(text.str().find(digest), std::string::npos) << repetition;
  }
}

TEST(Plan, WritesAPictureAndATrace) {
  const ScratchFolder scratch;
  const Finished plan =
      pathrace({"plan", "--scenario", "trap-u/20/3", "--planner", "as:dead_end=backtrack", "--svg",
                scratch / "a.svg", "--trace", scratch / "a.csv", "--backend", "threads"});
  ASSERT_EQ(plan.exit_code, 0) << plan.err;
  std::ifstream svg(scratch / "a.svg");
  std::string first;
  std::getline(svg, first);
  EXPECT_NE(first.find('<'), std::string::npos);
  std::ifstream trace(scratch / "a.csv");
  std::getline(trace, first);
  EXPECT_EQ(first, "evaluations,iterations,checks,wall_s,length");
}

}  // namespace
}  // namespace pathrace::bench
