// Ctrl-C, as a person presses it while `run` is busy with each kind of planner on a large map.
#include "bench/stop.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/checkpoint.hpp"
#include "tests/bench/command_line.hpp"
#include "tests/support/running.hpp"

namespace pathrace::bench {
namespace {

using testing::Running;
using testing::ScratchFolder;

constexpr double patience_s = 1;  // of processor time, from the signal to the end of the process

// Walls across a square map, each with one gap, at the left and the right in turn; a scen with one long
// query.
std::string walled_map(int side) {
  std::string text = fmt::format("type octile\nheight {0}\nwidth {0}\nmap\n", side);
  for (int y = 0; y < side; ++y) {
    std::string row(static_cast<std::size_t>(side), y % 64 == 32 ? '@' : '.');
    if (y % 64 == 32) row.replace(y % 128 == 32 ? 8 : row.size() - 16, 8, "........");
    text += row + "\n";
  }
  return text;
}

std::string campaign_on(const ScratchFolder& scratch, const std::string& select, const std::string& planner,
                        int repetitions) {
  const std::string maps = select.starts_with("movingai/") ? "maps = \".\"\n" : "";
  return scratch.file(
      "campaign.toml",
      fmt::format("[campaign]\nname = \"long\"\n{}repetitions = {}\n[budget]\n"
                  "evaluations = 1000000000\n[[planner]]\n{}\n[[scenarios]]\nselect = [\"{}\"]\n",
                  maps, repetitions, planner, select));
}

std::vector<std::string> run_of(const std::string& campaign, const std::string& out) {
  return {"run", campaign, "--out", out, "--jobs", "1", "--backend", "threads", "--no-features"};
}

void expect_an_orderly_end(Running& run, const ScratchFolder& scratch) {
  const double before = run.worked_s();
  run.send(SIGINT);
  const Running::End end = run.wait();
  EXPECT_TRUE(WIFEXITED(end.status) && WEXITSTATUS(end.status) == 130) << end.status << run.err();
  EXPECT_LT(end.user_and_sys - before, patience_s) << run.err();
  EXPECT_NE(run.err().find("interrupted; "), std::string::npos) << run.err();
  const testing::Finished digest = pathrace({"digest", scratch / "run", "--json"});
  EXPECT_EQ(digest.exit_code, 0) << digest.err;
}

class StopInsideOf : public ::testing::TestWithParam<const char*> {};

TEST_P(StopInsideOf, APlannerEndsTheRunWithinASecond) {
  const ScratchFolder scratch;
  const std::string planner = GetParam();
  const bool moves =
      planner.find("replan") != std::string::npos || planner.find("d-star") != std::string::npos;
  scratch.file("walls.map", walled_map(1024));
  scratch.file("walls.map.scen", "version 1\n0\twalls.map\t1024\t1024\t0\t0\t1023\t1023\t17000\n");
  const std::string select = moves ? "discs/c-trap/1..30" : "movingai/walls/1";
  Running run(PATHRACE_BINARY, run_of(campaign_on(scratch, select, planner, 5000), scratch / "run"));
  ASSERT_TRUE(run.says(" of 1 thread")) << run.err();
  ASSERT_TRUE(run.works(0.5)) << run.err();
  expect_an_orderly_end(run, scratch);
}

INSTANTIATE_TEST_SUITE_P(
    EachKind, StopInsideOf,
    ::testing::Values("name = \"as\"", "name = \"mmas\"\nparams = { dead_end = \"backtrack\" }",
                      "name = \"acs\"\nparams = { dead_end = \"revisit_with_loop_erasure\" }",
                      "name = \"tan2016\"\nparams = { dead_end = \"backtrack\" }", "name = \"pu2022\"",
                      "name = \"xie2010\"\nparams = { insertion = \"general\", repair = \"local_search\" }",
                      "name = \"pso\"", "name = \"dijkstra\"", "name = \"astar\"", "name = \"jps\"",
                      "name = \"theta-star\"", "name = \"any-angle-optimum\"", "name = \"random-walk\"",
                      "name = \"greedy\"", "name = \"replan(as)\"", "name = \"d-star-lite\""),
    [](const auto& planner) {
      std::string name = planner.param;
      name = name.substr(8, name.find('"', 8) - 8);
      for (char& c : name) {
        if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
      }
      return name;
    });

TEST(Stop, DuringProofsEndsTheRunBeforeTheFirstTrial) {
  const ScratchFolder scratch;
  scratch.file("walls.map", walled_map(4096));
  scratch.file("walls.map.scen", "version 1\n0\twalls.map\t4096\t4096\t0\t0\t4095\t4095\t17000\n");
  Running run(PATHRACE_BINARY,
              run_of(campaign_on(scratch, "movingai/walls/1", "name = \"astar\"", 1), scratch / "run"));
  ASSERT_TRUE(run.handles(SIGINT)) << run.err();
  ASSERT_TRUE(run.works(0.2)) << run.err();
  expect_an_orderly_end(run, scratch);
  EXPECT_NE(run.err().find("; 0 of 1 trials are recorded"), std::string::npos) << run.err();
}

TEST(Stop, TrialsThatWereCutRunAgainWhenTheRunIsResumed) {
  const ScratchFolder scratch;
  const std::string campaign = scratch.file(
      "campaign.toml",
      "[campaign]\nname = \"some\"\nseed = 3\nrepetitions = 40\n[budget]\nevaluations = 20000\n[[planner]]\n"
      "name = \"as\"\n[[scenarios]]\nselect = [\"dense/20-20/1\"]\n");
  ASSERT_EQ(pathrace(run_of(campaign, scratch / "whole")).exit_code, 0);
  {
    Running run(PATHRACE_BINARY, run_of(campaign, scratch / "run"));
    ASSERT_TRUE(run.says(" of 1 thread")) << run.err();
    run.works(0.2);
    run.send(SIGINT);
    run.wait();
  }
  std::vector<std::string> resumed = run_of(campaign, scratch / "run");
  resumed.emplace_back("--resume");
  ASSERT_EQ(pathrace(resumed).exit_code, 0);
  EXPECT_EQ(pathrace({"digest", scratch / "run"}).out, pathrace({"digest", scratch / "whole"}).out);
}

TEST(Stop, APlanIsOverAtOnce) {
  Running plan(PATHRACE_BINARY, {"plan", "--scenario", "dense/20-20/7", "--planner", "as", "--evaluations",
                                 "1000000000", "--backend", "serial"});
  ASSERT_TRUE(plan.works(0.1));
  plan.send(SIGINT);
  const Running::End end = plan.wait();
  EXPECT_TRUE(WIFSIGNALED(end.status) && WTERMSIG(end.status) == SIGINT) << end.status;  // 130 in a shell
}

TEST(Stop, TheFirstSignalAsksAndTheSecondEndsTheProcess) {
  const auto press_twice = [](int signal) {
    stop_on_signals();
    raise(signal);
    if (!stop_requested.load()) _exit(1);
    raise(signal);
    _exit(2);
  };
  EXPECT_EXIT(press_twice(SIGINT), ::testing::KilledBySignal(SIGINT), "");
  EXPECT_EXIT(press_twice(SIGTERM), ::testing::KilledBySignal(SIGTERM), "");
}

}  // namespace
}  // namespace pathrace::bench
