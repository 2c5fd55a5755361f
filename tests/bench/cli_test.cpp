// The command line as a person meets it: what it prints, and how it refuses.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/bench/command_line.hpp"

namespace pathrace::bench {
namespace {

using testing::Finished;
using testing::ScratchFolder;
using Json = nlohmann::json;

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

TEST(Scenarios, ListingSaysWhatItLeavesOut) {
  const Finished combs = pathrace({"scenarios", "list", "--family", "trap-comb/10", "--json"});
  EXPECT_EQ(Json::parse(combs.out).size(), 28U);
  EXPECT_EQ(combs.err,
            "not listed, since they repeat an earlier question: trap-comb/10/21 (trap-comb/10/14), "
            "trap-comb/10/29 (trap-comb/10/7)\n");
  EXPECT_EQ(pathrace({"scenarios", "list", "--family", "trap-l/20", "--json"}).err, "");
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
