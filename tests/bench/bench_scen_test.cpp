// `bench-scen`: whose word counts when the file's does not.
#include <nlohmann/json.hpp>

#include "tests/bench/command_line.hpp"

namespace pathrace::bench {
namespace {

using testing::Finished;
using testing::ScratchFolder;
using Json = nlohmann::json;

// On the small map the shortest 8-connected way from 0,0 to 3,2 goes around the block: 5.
class ScenJudging : public ::testing::Test {
 protected:
  Finished run(const std::string& queries, const std::vector<std::string>& more = {}) {
    const std::string scen = scratch_.file("small.map.scen", "version 1\n" + queries);
    std::vector<std::string> arguments = {"bench-scen", "--map", map_, "--scen", scen};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return pathrace(arguments);
  }
  Json report(const std::string& queries, int exit_code, std::vector<std::string> more = {}) {
    more.emplace_back("--json");
    const Finished finished = run(queries, more);
    EXPECT_EQ(finished.exit_code, exit_code) << finished.err;
    return Json::parse(finished.out);
  }

  ScratchFolder scratch_;
  std::string map_ = scratch_.file("small.map", small_map);
};

TEST_F(ScenJudging, OfWhichEveryQueryIsBadMeasuredNothing) {
  const Finished scaled = run("0\tsmall.map\t8\t6\t0\t0\t6\t4\t10\n");
  EXPECT_EQ(scaled.exit_code, 1);
  EXPECT_NE(scaled.err.find("nothing was measured: all 1 queries are bad"), std::string::npos) << scaled.err;
}

TEST_F(ScenJudging, AnOptimumOf0BetweenDifferentCellsIsUnknownAndProvenHere) {
  const std::string unknown = "0\tsmall.map\t4\t3\t0\t0\t3\t2\t0\n";
  const Json right = report(unknown, 0);
  EXPECT_EQ(right["matched"], 1);
  EXPECT_EQ(right["proven_here"], 1);
  EXPECT_NE(run(unknown).out.find("stands for unknown"), std::string::npos);
  // From a cell to itself 0 is the optimum.
  EXPECT_EQ(report("0\tsmall.map\t4\t3\t0\t0\t0\t0\t0\n", 0)["proven_here"], 0);
  // A greedy walk ends in the cup.
  map_ =
      scratch_.file("small.map", "type octile\nheight 5\nwidth 5\nmap\n.....\n.@@@.\n...@.\n.@@@.\n.....\n");
  const Json wrong = report("0\tsmall.map\t5\t5\t0\t2\t4\t2\t0\n", 1, {"--planner", "greedy"});
  EXPECT_EQ(wrong["mismatched"], 1);
}

TEST_F(ScenJudging, NoWayIsTheRightAnswerWhereThereIsNone) {
  map_ = scratch_.file("small.map", "type octile\nheight 3\nwidth 3\nmap\n.@.\n.@.\n.@.\n");
  const Json right = report("0\tsmall.map\t3\t3\t0\t0\t2\t2\t0\n", 0);
  EXPECT_EQ(right["matched"], 1);
  EXPECT_EQ(right["proven_here"], 1);
  // A file that prints a length is wrong, not the planner.
  const Json bad = report("0\tsmall.map\t3\t3\t0\t0\t2\t2\t2.82843\n", 1);
  EXPECT_EQ(bad["bad_queries"], 1);
}

TEST_F(ScenJudging, AnyAngleWaysAreComparedWithTheAnyAngleOptimum) {
  const std::string query = "0\tsmall.map\t4\t3\t0\t0\t3\t2\t5\n";
  const Json optimum = report(query, 0, {"--planner", "any-angle-optimum"});
  EXPECT_EQ(optimum["matched"], 1);
  EXPECT_EQ(optimum["proven_here"], 1);
  EXPECT_NE(run(query, {"--planner", "any-angle-optimum"}).out.find("any-angle optimum, since the file's"),
            std::string::npos);
  // No way at any angle is shorter than sqrt(3^2 + 2^2) = 3.606.
  EXPECT_EQ(
      report("0\tsmall.map\t4\t3\t0\t0\t3\t2\t3.5\n", 1, {"--planner", "any-angle-optimum"})["bad_queries"],
      1);
}

TEST_F(ScenJudging, CoordinatesAreWholeNumbers) {
  expect_refusal(run("0\tsmall.map\t4\t3\t0.0\t0.0\t3.0\t2.0\t5\n"),
                 {"small.map.scen:2", "start x '0.0'", "expected a whole number"});
}

}  // namespace
}  // namespace pathrace::bench
