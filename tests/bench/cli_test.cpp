// The command line as a person meets it: what it prints, and how it refuses.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/support/process.hpp"

namespace pathrace::bench {
namespace {

using testing::Finished;
using testing::run_program;
using testing::ScratchFolder;
using Json = nlohmann::json;

constexpr const char* small_map = "type octile\nheight 3\nwidth 4\nmap\n....\n.@@.\n....\n";

Finished pathrace(const std::vector<std::string>& arguments) {
  return run_program(PATHRACE_BINARY, arguments);
}

// Bad input: exit code 2 (or 3), nothing on stdout, one line on stderr that holds all these words.
void expect_refusal(const Finished& finished, const std::vector<std::string>& words, int code = 2) {
  EXPECT_EQ(finished.exit_code, code) << finished.out << finished.err;
  EXPECT_EQ(std::count(finished.err.begin(), finished.err.end(), '\n'), 1) << finished.err;
  EXPECT_TRUE(finished.err.starts_with("pathrace: ")) << finished.err;
  for (const std::string& word : words) {
    EXPECT_NE(finished.err.find(word), std::string::npos) << "'" << word << "' is not in: " << finished.err;
  }
}

TEST(CommandLine, HelpShowsEveryCommandAndEachHasAnExample) {
  const Finished help = pathrace({"--help"});
  EXPECT_EQ(help.exit_code, 0);
  for (const char* command :
       {"run", "plan", "bench-scen", "planners", "scenarios", "leaderboard", "verify", "digest"}) {
    EXPECT_NE(help.out.find(command), std::string::npos) << command;
    const Finished own = pathrace({command, "--help"});
    EXPECT_EQ(own.exit_code, 0) << command;
    EXPECT_NE(own.out.find("Example:\n"), std::string::npos) << own.out;
  }
}

TEST(CommandLine, MisspeltWordsAreAnsweredWithTheNearestMatch) {
  expect_refusal(pathrace({"rum"}), {"rum", "'run'"});
  expect_refusal(pathrace({"run", "--campaign", "smoek"}), {"smoek", "'smoke'"});
  expect_refusal(pathrace({"run", "--backend", "opnmp"}), {"opnmp", "'openmp'"});
  expect_refusal(pathrace({"planners", "describe", "asta"}), {"asta", "'astar'"});
  expect_refusal(pathrace({"plan", "--scenario", "asr/fig2", "--planner", "as:ant=3"}), {"ant", "'ants'"});
  expect_refusal(pathrace({"plan", "--scenario", "tarp-u/20/1", "--planner", "astar"}),
                 {"tarp-u", "'trap-u'"});
  expect_refusal(pathrace({"plan", "--scenario", "asr/fig2", "--planner", "astar", "--rule", "strikt"}),
                 {"'strict'"});
}

TEST(CommandLine, ValuesOutOfRangeAreRefused) {
  expect_refusal(pathrace({"run", "--jobs", "0"}), {"--jobs", "0"});
  expect_refusal(pathrace({"run", "--threads", "1000"}), {"--threads", "1000"});
  expect_refusal(pathrace({"run", "--seed", "-1"}), {"--seed"});
  expect_refusal(pathrace({"plan", "--scenario", "asr/fig2", "--planner", "as", "--evaluations", "0"}),
                 {"--evaluations"});
  expect_refusal(pathrace({"plan", "--scenario", "asr/fig2", "--planner", "as:ants=0"}),
                 {"ants", "1..100000", "'0'"});
  expect_refusal(pathrace({"plan", "--scenario", "asr/fig2", "--planner", "as:alpha=nan"}), {"alpha", "nan"});
  expect_refusal(pathrace({"plan", "--scenario", "dense/20-90/1", "--planner", "as"}),
                 {"percent", "0..40", "'90'"});
  expect_refusal(pathrace({"run", "--nonsense"}), {"--nonsense"});
}

TEST(CommandLine, StartsAndGoalsAreChecked) {
  const ScratchFolder scratch;
  const std::string map = scratch.file("small.map", small_map);
  const auto plan = [&](const std::string& start, const std::string& goal) {
    return pathrace({"plan", "--map", map, "--start", start, "--goal", goal, "--planner", "astar"});
  };
  expect_refusal(plan("9,0", "0,0"), {"start", "9,0", "outside"});
  expect_refusal(plan("0,0", "1,1"), {"goal", "1,1", "blocked"});
  expect_refusal(plan("0,0", "-1,0"), {"goal", "-1,0", "outside"});
  expect_refusal(plan("zero", "0,0"), {"--start", "zero", "X,Y"});
  EXPECT_EQ(plan("0,0", "3,2").exit_code, 0);
}

TEST(CommandLine, BadMapsAreRefused) {
  const ScratchFolder scratch;
  const auto plan = [](const std::string& map) {
    return pathrace({"plan", "--map", map, "--start", "0,0", "--goal", "1,0", "--planner", "astar"});
  };
  expect_refusal(plan(scratch / "none.map"), {"none.map"});
  expect_refusal(plan(scratch.file("empty.map", "")), {"empty.map"});
  expect_refusal(plan(scratch.file("cut.map", "type octile\nheight 3\nwidth 4\nmap\n....\n")),
                 {"cut.map", "3"});
  expect_refusal(plan(scratch.file("huge.map", "type octile\nheight 999999999\nwidth 9\nmap\n")),
                 {"huge.map:2", "999999999"});
  expect_refusal(plan(scratch.file("binary.map", std::string("\x7f"
                                                             "ELF\0\1\2\n\0",
                                                             9))),
                 {"binary.map:1"});
}

TEST(CommandLine, AScenForAnotherMapIsRefused) {
  const ScratchFolder scratch;
  const std::string map = scratch.file("small.map", small_map);
  const std::string scen =
      scratch.file("small.map.scen", "version 1\n0\tother.map\t4\t3\t0\t0\t3\t2\t4.41421\n");
  expect_refusal(pathrace({"bench-scen", "--map", map, "--scen", scen}),
                 {"small.map.scen:2", "other.map", "small.map"});
}

TEST(BenchScen, CountsMatchesMismatchesAndBadQueries) {
  const ScratchFolder scratch;
  const std::string map = scratch.file("small.map", small_map);
  const std::string scen =
      scratch.file("small.map.scen",
                   "version 1\n"
                   "0\tx/small.map\t4\t3\t0\t0\t3\t0\t3\n"          // right
                   "0\tx/small.map\t4\t3\t0\t0\t3\t2\t5\n"          // right: around the block
                   "0\tx/small.map\t4\t3\t0\t0\t0\t0\t0\n"          // right: nowhere to go
                   "0\tx/small.map\t4\t3\t0\t0\t3\t0\t4\n"          // a path of 3 is shorter
                   "0\tx/small.map\t4\t3\t1\t1\t3\t0\t3\n"          // starts on a blocked cell
                   "0\tx/small.map\t9\t9\t0\t0\t3\t0\t3\n"          // another size
                   "0\tx/small.map\t4\t3\t0\t0\t3\t2\t4.41421\n");  // too short to be true
  const Finished astar = pathrace({"bench-scen", "--map", map, "--scen", scen, "--json"});
  EXPECT_EQ(astar.exit_code, 1) << astar.err;
  const Json report = Json::parse(astar.out);
  EXPECT_EQ(report["queries"], 7);
  EXPECT_EQ(report["matched"], 3);
  EXPECT_EQ(report["mismatched"], 1);
  EXPECT_EQ(report["bad_queries"], 3);
  for (const char* key : {"map", "planner", "setup_us", "us_per_query_mean", "us_per_query_median",
                          "expansions", "expansions_per_second"}) {
    EXPECT_TRUE(report.contains(key)) << key;
  }
  const Finished limited = pathrace({"bench-scen", "--map", map, "--scen", scen, "--limit", "2", "--json"});
  EXPECT_EQ(Json::parse(limited.out)["queries"], 2);
}

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

TEST(Run, WritesTheFilesOfTheContractAndALeaderboardRowPerPlanner) {
  const ScratchFolder scratch;
  const Finished run =
      pathrace({"run", "--campaign", "smoke", "--out", scratch / "run", "--backend", "threads"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  for (const char* file : {"results.db", "leaderboard.csv", "trials.csv", "scenarios.csv", "campaign.toml"}) {
    EXPECT_TRUE(std::filesystem::exists(scratch / ("run/" + std::string(file)))) << file;
  }
  std::ifstream board(scratch / "run/leaderboard.csv");
  std::string line;
  std::getline(board, line);
  EXPECT_TRUE(line.starts_with(
      "rank,planner,track,trials,solved,success,gap_median,gap_solved,length_median,turns_median,"
      "evaluations_median,checks_median,time_ms_median"))
      << line;
  int rows = 0;
  while (std::getline(board, line)) ++rows;
  EXPECT_EQ(rows, 8);
}

TEST(Run, AFolderThatHoldsAStoreIsRefusedAndKept) {
  const ScratchFolder scratch;
  ASSERT_EQ(
      pathrace({"run", "--campaign", "smoke", "--out", scratch / "run", "--backend", "threads"}).exit_code,
      0);
  const std::string before = pathrace({"digest", scratch / "run"}).out;
  expect_refusal(pathrace({"run", "--campaign", "smoke", "--out", scratch / "run"}), {"--resume"});
  const Finished other =
      pathrace({"run", "--campaign", "smoke", "--seed", "9", "--resume", "--out", scratch / "run"});
  expect_refusal(other, {"another campaign", "seed 9"});
  EXPECT_EQ(pathrace({"digest", scratch / "run"}).out, before);
  EXPECT_EQ(pathrace({"run", "--resume", "--out", scratch / "run"}).exit_code, 0);
  EXPECT_EQ(pathrace({"digest", scratch / "run"}).out, before);
}

TEST(Run, ResumingAMissingFolderStartsIt) {
  const ScratchFolder scratch;
  EXPECT_EQ(
      pathrace({"run", "--campaign", "smoke", "--resume", "--out", scratch / "new", "--backend", "threads"})
          .exit_code,
      0);
  EXPECT_NE(pathrace({"digest", scratch / "new", "--json"}).out.find("\"recorded\":464"), std::string::npos);
}

TEST(Run, ADryRunRunsNothing) {
  const ScratchFolder scratch;
  const Finished dry =
      pathrace({"run", "--campaign", "smoke", "--dry-run", "--out", scratch / "run", "--backend", "threads"});
  EXPECT_EQ(dry.exit_code, 0) << dry.err;
  EXPECT_NE(dry.out.find("464 trials"), std::string::npos) << dry.out;
  EXPECT_NE(dry.out.find("about"), std::string::npos) << dry.out;
  EXPECT_FALSE(std::filesystem::exists(scratch / "run"));
}

TEST(Run, AnOutputThatIsAFileIsRefused) {
  const ScratchFolder scratch;
  expect_refusal(pathrace({"run", "--campaign", "smoke", "--out", scratch.file("taken", "x")}),
                 {"taken", "folder"});
}

TEST(Run, AnOutputThatCannotBeMadeIsTheEnvironmentsFault) {
  expect_refusal(pathrace({"run", "--campaign", "smoke", "--out", "/proc/pathrace"}), {"/proc/pathrace"}, 3);
}

TEST(Run, DamagedAndForeignStoresAreRefused) {
  const ScratchFolder scratch;
  std::filesystem::create_directory(scratch / "run");
  for (const auto& [text, word] :
       {std::pair<std::string, std::string>{"", "results.db"}, {"not a database at all", "results.db"}}) {
    scratch.file("run/results.db", text);
    for (const char* command : {"leaderboard", "verify", "digest"})
      expect_refusal(pathrace({command, scratch / "run"}), {word});
    expect_refusal(pathrace({"run", "--campaign", "smoke", "--resume", "--out", scratch / "run"}), {word});
  }
  expect_refusal(pathrace({"leaderboard", scratch / "nowhere"}), {"nowhere"});
}

TEST(Run, ACampaignFileThatIsWrongIsNamedWithItsLine) {
  const ScratchFolder scratch;
  expect_refusal(pathrace({"run", scratch / "none.toml"}), {"none.toml"});
  expect_refusal(pathrace({"run", scratch.file("bad.toml", "[campaign]\nname = \n")}), {"bad.toml:2:"});
  expect_refusal(pathrace({"run", scratch.path().string()}), {"folder"});
}

TEST(Run, RecordedMapsJoinTheRace) {
  const ScratchFolder scratch;
  scratch.file("small.map", small_map);
  scratch.file("small.map.scen",
               "version 1\n0\tsmall.map\t4\t3\t0\t0\t3\t0\t3\n0\tsmall.map\t4\t3\t1\t1\t3\t0\t3\n");
  const Finished run = pathrace({"run", "--campaign", "smoke", "--maps", scratch.path().string(), "--out",
                                 scratch / "run", "--backend", "threads"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.err.find("left out"), std::string::npos) << run.err;  // the query on a blocked cell
  EXPECT_NE(run.err.find("480 trials"), std::string::npos) << run.err;
  const Finished verify = pathrace({"verify", scratch / "run", "--backend", "threads"});
  EXPECT_EQ(verify.exit_code, 0) << verify.out << verify.err;
  std::filesystem::remove(scratch / "small.map");
  expect_refusal(pathrace({"verify", scratch / "run"}), {"small.map"});
}

TEST(Scenarios, ListsShowsExportsAndChecks) {
  const ScratchFolder scratch;
  const Json list = Json::parse(pathrace({"scenarios", "list", "--family", "trap-l/20", "--json"}).out);
  ASSERT_EQ(list.size(), 30U);
  for (const char* key : {"id", "family", "width", "height", "rule", "start", "goal", "optimum", "hash"}) {
    EXPECT_TRUE(list[0].contains(key)) << key;
  }
  EXPECT_EQ(pathrace({"scenarios", "list", "--family", "trap-l/2"}).exit_code, 2);
  EXPECT_NE(pathrace({"scenarios", "show", "asr/fig5"}).out.find("S....\n...#.\n.#...\n.....\n....G\n"),
            std::string::npos);
  ASSERT_EQ(pathrace({"scenarios", "export", "asr/fig5", "--format", "map", "-o", scratch / "asr-fig5.map"})
                .exit_code,
            0);
  ASSERT_EQ(
      pathrace({"scenarios", "export", "asr/fig5", "--format", "scen", "-o", scratch / "asr-fig5.map.scen"})
          .exit_code,
      0);
  EXPECT_EQ(pathrace({"scenarios", "check", scratch / "asr-fig5.map"}).exit_code, 0);
  EXPECT_EQ(pathrace({"scenarios", "check", scratch / "asr-fig5.map.scen"}).exit_code, 0);
  const Finished bench =
      pathrace({"bench-scen", "--map", scratch / "asr-fig5.map", "--scen", scratch / "asr-fig5.map.scen"});
  EXPECT_EQ(bench.exit_code, 0) << bench.err;
  expect_refusal(pathrace({"scenarios", "export", "asr/fig5", "--format", "mpa"}), {"'map'"});
}

TEST(Planners, DescribeTellsEveryParameter) {
  const Json list = Json::parse(pathrace({"planners", "--json"}).out);
  ASSERT_TRUE(list.is_array());
  for (const char* key : {"name", "kind", "track", "deterministic", "source", "version"}) {
    EXPECT_TRUE(list[0].contains(key)) << key;
  }
  const Json as = Json::parse(pathrace({"planners", "describe", "as", "--json"}).out);
  EXPECT_EQ(as["default_budget"]["iterations"], 100);
  for (const Json& parameter : as["parameters"]) {
    for (const char* key : {"name", "type", "default", "range", "unit", "source", "tag"}) {
      EXPECT_TRUE(parameter.contains(key)) << key;
    }
  }
}

}  // namespace
}  // namespace pathrace::bench
