// The leaderboard as text: CSV for programs, columns for people.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "core/utf8.hpp"
#include "results/leaderboard.hpp"
#include "tests/results/rows.hpp"

namespace pathrace::results {
namespace {

constexpr const char* header =
    "rank,planner,track,trials,solved,success,gap_median,gap_solved,length_median,turns_median,"
    "evaluations_median,checks_median,time_ms_median,time_pass,steps_median,collisions_mean,struck_mean,"
    "min_clearance_median,oscillations_median,step_ms_median,step_ms_p99_median,gave_up,crashed,invalid";

std::string csv(const std::vector<Standing>& standings) {
  std::ostringstream out;
  write_csv(out, standings);
  return out.str();
}

std::string console(const std::vector<Standing>& standings, std::size_t width = console_width) {
  std::ostringstream out;
  print_console(out, standings, width);
  return out.str();
}

std::size_t longest_line(const std::string& text) {
  std::size_t longest = 0;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) longest = std::max(longest, letter_count(line));
  return longest;
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

TEST(LeaderboardCsv, HasTheAgreedColumnsAndEmptyCellsForNothing) {
  const std::string row =
      "1,\"as:ants=20,alpha=1\",lattice,4,3,0.75,,0.0625,28.5,6.5,5000,"
      "1234567,0.03125,alone,,,,,,,,0,0,0";
  EXPECT_EQ(csv({some_standing()}), fmt::format("{}\n{}\n", header, row));
  EXPECT_EQ(csv({}), fmt::format("{}\n", header));
}

TEST(LeaderboardCsv, NamesTheFamilyLast) {
  Standing standing = some_standing();
  standing.group = "trap-u";
  standing.crowded = true;
  const std::string text = csv({standing});
  EXPECT_EQ(text.substr(0, text.find('\n')), fmt::format("{},family", header));
  EXPECT_NE(text.find(",crowded,,,,,,,,0,0,0,trap-u\n"), std::string::npos);
}

TEST(LeaderboardConsole, AlignsItsColumns) {
  Standing first = some_standing();
  Standing second = some_standing();
  second.rank = 12;
  second.planner = "\xC3\xA9t\xC3\xA9";
  second.gap_median = 0.1;
  EXPECT_EQ(
      console({first, second}),
      "lattice: from cell to cell\n"
      "rank  planner             trials  solved  success     gap  gap solved  length  turns  "
      "evaluations   checks      ms\n"
      "   1  as:ants=20,alpha=1       4       3    75.0%       -       6.25%   28.50    6.5  "
      "       5000  1234567  0.0312\n"
      "  12  \xC3\xA9t\xC3\xA9                      4       3    75.0%  10.00%       6.25%   28.50    6.5  "
      "       5000  1234567  0.0312\n"
      "\n" +
          std::string(ranking_rule) + "\n");
}

TEST(LeaderboardConsole, ShowsRunsInATableWithColumnsOfTheirOwn) {
  Standing path = some_standing();
  Standing run = some_standing();
  run.track = Track::dynamic;
  run.steps_median = 41;
  run.collisions_mean = 0.25;
  const std::string text = console({path, run}, 0);
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
  EXPECT_NE(console({standing}).find("0.0312~\n"), std::string::npos);
}

TEST(LeaderboardConsole, PrintsATablePerTrack) {
  Standing lattice = some_standing();
  Standing any_angle = some_standing();
  any_angle.track = Track::any_angle;
  const std::string text = console({lattice, any_angle});
  EXPECT_EQ(text.find("lattice: from cell to cell\nrank"), 0U);
  EXPECT_NE(text.find("\n\nany_angle: straight through free space\nrank"), std::string::npos);
}

TEST(LeaderboardConsole, CountsFailuresOnlyWhereThereAreSome) {
  Standing lattice = some_standing();
  Standing any_angle = some_standing();
  any_angle.track = Track::any_angle;
  any_angle.crashed = 3;
  const std::string text = console({lattice, any_angle});
  const std::size_t second = text.find("any_angle:");
  EXPECT_EQ(text.find("crashed"), text.find("crashed", second));
  EXPECT_NE(text.find("0.0312         3\n", second), std::string::npos) << text;
  EXPECT_EQ(text.find("invalid"), std::string::npos);
  EXPECT_EQ(text.find("gave up"), std::string::npos);
}

TEST(LeaderboardConsole, FitsItsLines) {
  Standing standing = some_standing();
  standing.planner = "xie2010:insertion=general,repair=local_search,mutation=stretch,initial_genes=8";
  standing.gave_up = standing.crashed = standing.invalid = 1'000'000;
  standing.checks_median = 12345678901;
  Standing run = standing;
  run.track = Track::dynamic;
  run.steps_median = run.collisions_mean = run.struck_mean = run.min_clearance_median = 12345;
  run.oscillations_median = run.step_ms_median = run.step_ms_p99_median = 12345;
  for (const std::size_t width : {90U, 120U}) {
    const std::string text = console({standing, run}, width);
    EXPECT_LE(longest_line(text), std::max<std::size_t>(width, std::string(ranking_rule).size())) << text;
    EXPECT_NE(text.find("xie2010:"), std::string::npos) << text;
    EXPECT_NE(text.find("\u2026"), std::string::npos) << text;
    EXPECT_NE(text.find("enes=8 "), std::string::npos) << text;
  }
  const std::string whole = console({standing, run}, 0);
  EXPECT_NE(whole.find(standing.planner), std::string::npos);
  for (const char* column : {"turns", "oscillations", "p99"}) {
    EXPECT_NE(whole.find(column), std::string::npos) << column;
    EXPECT_EQ(console({standing, run}).find(column), std::string::npos) << column;
  }
}

TEST(LeaderboardConsole, PrintsATablePerFamily) {
  Standing first = some_standing();
  Standing second = some_standing();
  first.group = "dense";
  second.group = "trap-u";
  const std::string text = console({first, first, second});
  EXPECT_EQ(text.find("dense, lattice: from cell to cell\nrank"), 0U);
  EXPECT_NE(text.find("\n\ntrap-u, lattice: from cell to cell\nrank"), std::string::npos);
  EXPECT_EQ(text.find("dense", 5), std::string::npos);
}

TEST(LeaderboardConsole, NamesFromAForeignStoreDoNotCommandTheTerminal) {
  Standing standing = some_standing();
  standing.planner = "\x1b[31mRED\nrow";
  standing.group = "a\x07";
  const std::string text = console({standing});
  EXPECT_NE(text.find("\\x1b[31mRED\\x0arow"), std::string::npos) << text;
  EXPECT_NE(text.find("a\\x07, lattice"), std::string::npos) << text;
  EXPECT_EQ(text.find_first_of("\x1b\x07"), std::string::npos);
}

TEST(LeaderboardConsole, SaysSoWhenThereIsNothing) {
  EXPECT_EQ(console({}), "no trials\n");
}

}  // namespace
}  // namespace pathrace::results
