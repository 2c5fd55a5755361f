// `pathrace run`: the folder of a campaign, and what is refused before anything is lost.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/bench/command_line.hpp"

namespace pathrace::bench {
namespace {

using testing::Finished;
using testing::ScratchFolder;

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

TEST(Run, ThereMustBeAStoreToResume) {
  const ScratchFolder scratch;
  expect_refusal(pathrace({"run", "--campaign", "smoke", "--resume", "--out", scratch / "new"}),
                 {"new", "results.db", "--resume"});
  EXPECT_FALSE(std::filesystem::exists(scratch / "new"));
  std::filesystem::create_directory(scratch / "empty");
  expect_refusal(pathrace({"run", "--resume", "--out", scratch / "empty"}), {"empty", "results.db"});
  EXPECT_TRUE(std::filesystem::is_empty(scratch / "empty"));
}

TEST(Run, SaysWhatItRanOn) {
  const ScratchFolder scratch;
  const Finished run = pathrace({"run",
                                 scratch.file("x.toml",
                                              "[campaign]\nname = \"x\"\n[[planner]]\nname = \"astar\"\n"
                                              "[[scenarios]]\nselect = [\"trap-u/20/1\"]\n"),
                                 "--out", scratch / "run", "--backend", "serial", "--jobs", "1"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  std::ifstream in(scratch / "run/machine.csv");
  const std::string facts{std::istreambuf_iterator<char>(in), {}};
  for (const char* fact : {"session,name,value\n", "\n1,compiler,", "\n1,kernel,", "\n1,pathrace,0.1.0\n",
                           "\n1,tbb,", "\n1,sqlite,3.", "\n1,flags,", "\n1,date,2"}) {
    EXPECT_NE(facts.find(fact), std::string::npos) << fact << " in " << facts;
  }
}

#ifndef PATHRACE_OMPL
TEST(Run, WithoutOmplTheStarterLeavesItsPlannersOutAndAFileThatNamesThemIsRefused) {
  const Finished starter = pathrace({"run", "--dry-run"});
  EXPECT_EQ(starter.exit_code, 0);
  EXPECT_NE(starter.err.find("left out: ompl-rrt-connect, ompl-rrt-star, ompl-bit-star; each needs OMPL: "
                             "apt-get install libompl-dev"),
            std::string::npos)
      << starter.err;
  const std::vector<std::string> words{"'ompl-", "needs OMPL: apt-get install libompl-dev, then"};
  expect_refusal(pathrace({"run", std::string(PATHRACE_SOURCE_DIR) + "/campaigns/leaderboard.toml"}), words);
  expect_refusal(pathrace({"plan", "--scenario", "asr/fig2", "--planner", "ompl-rrt"}), words);
}
#endif

TEST(Run, CountsAtItsEndWhatFailed) {
  const ScratchFolder scratch;
  const std::string campaign = scratch.file("trap.toml", R"([campaign]
name = "trap"
repetitions = 2
[[planner]]
name = "greedy"
[[planner]]
name = "astar"
[[scenarios]]
select = ["trap-u/20/1"]
)");
  const Finished run = pathrace({"run", campaign, "--out", scratch / "run", "--backend", "threads"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_NE(run.err.find("trials without a result: gave up 2 (greedy 2)\n"), std::string::npos) << run.err;
  const Finished help = pathrace({"leaderboard", "--help"});
  EXPECT_NE(help.out.find("Ranked on each track by success, then gap"), std::string::npos);
  const std::string shown = pathrace({"leaderboard", scratch / "run"}).out;
  EXPECT_NE(shown.find("gave up"), std::string::npos) << shown;
  EXPECT_EQ(shown.find("crashed"), std::string::npos) << shown;
}

TEST(Run, ADryRunRunsNothing) {
  const ScratchFolder scratch;
  const Finished dry =
      pathrace({"run", "--campaign", "smoke", "--dry-run", "--out", scratch / "run", "--backend", "threads"});
  EXPECT_EQ(dry.exit_code, 0) << dry.err;
  EXPECT_NE(dry.out.find("464 trials"), std::string::npos) << dry.out;
  EXPECT_EQ(dry.out.find("about"), std::string::npos) << dry.out;  // nothing ran that could tell the time
  EXPECT_FALSE(std::filesystem::exists(scratch / "run"));
}

TEST(Run, SaysWhichScenariosRepeatAQuestion) {
  const ScratchFolder scratch;
  const auto said = [&](const std::string& pattern) {
    const std::string campaign =
        scratch.file("x.toml", "campaign = { name = \"x\" }\nplanner = [{ name = \"greedy\" }]\n" +
                                   ("scenarios = [{ select = [\"" + pattern + "\"] }]\n"));
    return pathrace({"run", campaign, "--dry-run", "--out", scratch / "run"}).err;
  };
  EXPECT_NE(
      said("trap-hook/10/1..30")
          .find(
              "1 of the scenarios asks the question of an earlier one: trap-hook/10/17 (trap-hook/10/14)\n"),
      std::string::npos);
  EXPECT_EQ(said("trap-hook/10/*").find("asks the question"), std::string::npos);
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

}  // namespace
}  // namespace pathrace::bench
