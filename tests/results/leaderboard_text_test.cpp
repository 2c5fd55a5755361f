// The leaderboard as text: CSV for programs, columns for people.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <sstream>

#include "results/leaderboard.hpp"
#include "tests/results/rows.hpp"

namespace pathrace::results {
namespace {

constexpr const char* header =
    "rank,planner,track,trials,solved,success,gap_median,gap_solved,length_median,turns_median,"
    "evaluations_median,checks_median,time_ms_median,time_pass,steps_median,collisions_mean,struck_mean,"
    "min_clearance_median,oscillations_median,step_ms_median,step_ms_p99_median";

std::string csv(const std::vector<Standing>& standings) {
  std::ostringstream out;
  write_csv(out, standings);
  return out.str();
}

std::string console(const std::vector<Standing>& standings) {
  std::ostringstream out;
  print_console(out, standings);
  return out.str();
}

Standing some_standing() {
  Standing standing;
  standing.rank = 1;
  standing.planner = "as:ants=20,alpha=1";
  standing.trials = 4;
  standing.solved = 3;
  standing.success = 0.75;
  standing.gap_solved = 0.0625;
  standing.length_median = 28.5;
  standing.turns_median = 6.5;
  standing.evaluations_median = 5000;
  standing.checks_median = 1234567;
  standing.time_ms_median = 0.03125;
  return standing;
}

TEST(LeaderboardCsv, HasTheAgreedColumnsAndADashForNothing) {
  const std::string row =
      "1,\"as:ants=20,alpha=1\",lattice,4,3,0.75,-,0.0625,28.5,6.5,5000,"
      "1234567,0.03125,alone,-,-,-,-,-,-,-";
  EXPECT_EQ(csv({some_standing()}), fmt::format("{}\n{}\n", header, row));
  EXPECT_EQ(csv({}), fmt::format("{}\n", header));
}

TEST(LeaderboardCsv, NamesTheFamilyLast) {
  Standing standing = some_standing();
  standing.group = "trap-u";
  standing.crowded = true;
  const std::string text = csv({standing});
  EXPECT_EQ(text.substr(0, text.find('\n')), fmt::format("{},family", header));
  EXPECT_NE(text.find(",crowded,-,-,-,-,-,-,-,trap-u\n"), std::string::npos);
}

TEST(LeaderboardConsole, AlignsItsColumns) {
  Standing first = some_standing();
  Standing second = some_standing();
  second.rank = 12;
  second.planner = "\xC3\xA9t\xC3\xA9";
  second.gap_median = 0.1;
  EXPECT_EQ(console({first, second}),
            "rank  planner             track    trials  solved  success     gap  gap solved  length  turns  "
            "evaluations   checks      ms\n"
            "   1  as:ants=20,alpha=1  lattice       4       3    75.0%       -       6.25%   28.50    6.5  "
            "       5000  1234567  0.0312\n"
            "  12  \xC3\xA9t\xC3\xA9                 lattice       4       3    75.0%  10.00%       6.25%   "
            "28.50    6.5  "
            "       5000  1234567  0.0312\n");
}

TEST(LeaderboardConsole, ShowsRunsInABlockWithColumnsOfTheirOwn) {
  Standing path = some_standing();
  Standing run = some_standing();
  run.track = Track::dynamic;
  run.steps_median = 41;
  run.collisions_mean = 0.25;
  const std::string text = console({path, run});
  const std::size_t gap = text.find("\n\n");
  ASSERT_NE(gap, std::string::npos) << text;
  EXPECT_NE(text.substr(0, gap).find("turns"), std::string::npos);
  EXPECT_EQ(text.substr(0, gap).find("steps"), std::string::npos);
  EXPECT_EQ(text.substr(gap).find("turns"), std::string::npos);
  EXPECT_NE(text.substr(gap).find("steps  collisions"), std::string::npos) << text;
  EXPECT_NE(text.substr(gap).find("   41        0.25"), std::string::npos) << text;
}

TEST(LeaderboardConsole, MarksTimesFromCrowdedTrials) {
  Standing standing = some_standing();
  EXPECT_EQ(console({standing}).find('~'), std::string::npos);
  standing.crowded = true;
  EXPECT_NE(console({standing}).find("0.0312~\n~ "), std::string::npos);
}

TEST(LeaderboardConsole, PrintsABlockPerFamily) {
  Standing first = some_standing();
  Standing second = some_standing();
  first.group = "dense";
  second.group = "trap-u";
  const std::string text = console({first, first, second});
  EXPECT_EQ(text.find("dense\nrank"), 0U);
  EXPECT_NE(text.find("\n\ntrap-u\nrank"), std::string::npos);
  EXPECT_EQ(text.find("dense", 5), std::string::npos);
}

TEST(LeaderboardConsole, SaysSoWhenThereIsNothing) {
  EXPECT_EQ(console({}), "no trials\n");
}

}  // namespace
}  // namespace pathrace::results
