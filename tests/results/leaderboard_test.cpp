#include "results/leaderboard.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "tests/results/rows.hpp"

namespace pathrace::results {
namespace {

/// A store that fills as the test speaks.
class Race {
 public:
  Race() : store_(Store::create(folder_ / "results.db", some_identity())) {}

  /// A solved trial with this gap on a map of optimum 10.
  Race& solved(const std::string& planner, double gap, const std::string& scenario = "dense/10-20/1") {
    TrialRow row = solved_row(++key_, planner, scenario);
    row.optimum = 10;
    row.gap = gap;
    row.length = 10 * (1 + gap);
    return add(row);
  }
  Race& failed(const std::string& planner, const std::string& scenario = "dense/10-20/1") {
    TrialRow row = failed_row(++key_, planner, scenario);
    row.optimum = 10;
    return add(row);
  }
  Race& add(TrialRow row) {
    row.key = ++key_;
    store_.append({row});
    return *this;
  }
  std::vector<Standing> standings(Grouping grouping = Grouping::all) const {
    return leaderboard(store_, grouping);
  }
  Standing only() const {
    EXPECT_EQ(standings().size(), 1U);
    return standings().front();
  }

 private:
  TemporaryFolder folder_;
  std::uint64_t key_ = 0;
  Store store_;
};

std::string order(const std::vector<Standing>& standings) {
  std::string text;
  for (const Standing& standing : standings) {
    text += (text.empty() ? "" : " ") + std::to_string(standing.rank) + standing.planner;
  }
  return text;
}

TEST(Leaderboard, CountsTrialsAndTakesMedians) {
  Race race;
  for (const double i : {1.0, 2.0, 3.0, 4.0}) {
    TrialRow row = solved_row(0, "as", "dense/10-20/1");
    row.optimum = 10;
    row.gap = i / 8;
    row.length = 10 + i;
    row.turns = static_cast<int>(i * i);
    row.work = {static_cast<std::uint64_t>(i * 10), 1, static_cast<std::uint64_t>(i * 1000)};
    row.costs.wall_s = i / 4;
    race.add(row);
  }
  const Standing standing = race.only();
  EXPECT_EQ(standing.rank, 1);
  EXPECT_EQ(standing.group, "");
  EXPECT_EQ(standing.planner, "as");
  EXPECT_EQ(standing.trials, 4U);
  EXPECT_EQ(standing.solved, 4U);
  EXPECT_EQ(standing.success, 1);
  EXPECT_EQ(standing.gap_median, 0.3125);  // between 2/8 and 3/8
  EXPECT_EQ(standing.gap_solved, 0.3125);
  EXPECT_EQ(standing.length_median, 12.5);
  EXPECT_EQ(standing.turns_median, 6.5);       // 1 4 9 16
  EXPECT_EQ(standing.evaluations_median, 25);  // 10 20 30 40
  EXPECT_EQ(standing.checks_median, 2500);
  EXPECT_EQ(standing.time_ms_median, 625);  // 250 500 750 1000
  EXPECT_FALSE(standing.crowded);
}

TEST(Leaderboard, TakesAFailureForAnInfiniteGap) {
  Race race;
  race.solved("as", 0.25).solved("as", 0.5).failed("as");
  EXPECT_EQ(race.only().success, 2.0 / 3);
  EXPECT_EQ(race.only().gap_median, 0.5);  // 0.25 0.5 infinite
  EXPECT_EQ(race.only().gap_solved, 0.375);
  EXPECT_EQ(race.only().length_median, 13.75);  // 12.5 15
}

TEST(Leaderboard, HasNoGapWhenHalfFail) {
  Race race;
  race.solved("as", 0).failed("as");
  EXPECT_FALSE(race.only().gap_median.has_value());
  EXPECT_EQ(race.only().gap_solved, 0);
}

TEST(Leaderboard, MeasuresWorkAndTimeOverFailuresToo) {
  Race race;
  TrialRow row = failed_row(0, "as", "dense/10-20/1");
  row.work = {100, 1, 900};
  row.costs.wall_s = 1;
  race.add(solved_row(0, "as", "dense/10-20/1")).add(row);
  EXPECT_EQ(race.only().evaluations_median, 50.5);  // 1 100
  EXPECT_EQ(race.only().checks_median, 451.5);      // 3 900
  EXPECT_EQ(race.only().time_ms_median, 500.5);     // 1 1000
}

TEST(Leaderboard, HasNoMetricsWhenNothingWasSolved) {
  Race race;
  race.failed("as");
  const Standing standing = race.only();
  EXPECT_EQ(standing.success, 0);
  EXPECT_FALSE(standing.gap_median || standing.gap_solved || standing.length_median || standing.turns_median);
  EXPECT_TRUE(standing.evaluations_median && standing.checks_median && standing.time_ms_median);
}

TEST(Leaderboard, LeavesTrialsWithoutAReferenceOutOfTheGapAlone) {
  Race race;
  TrialRow unknown = solved_row(0, "as", "movingai/x/1");
  unknown.optimum = unknown.gap = std::nullopt;
  unknown.length = 30;
  TrialRow lost = failed_row(0, "as", "movingai/x/2");
  lost.optimum = std::nullopt;
  race.add(unknown).add(lost);
  EXPECT_FALSE(race.only().gap_median || race.only().gap_solved);
  race.solved("as", 0.5);
  EXPECT_EQ(race.only().gap_median, 0.5);      // the failure had no reference
  EXPECT_EQ(race.only().length_median, 22.5);  // 15 30
  EXPECT_EQ(race.only().success, 2.0 / 3);
}

TEST(Leaderboard, CountsOnlySolvedAsSolved) {
  for (const auto& [verdict, text] : names_of<Verdict>) {
    Race race;
    TrialRow row = failed_row(0, "as", "dense/10-20/1");
    row.verdict = verdict;
    race.add(row);
    EXPECT_EQ(race.only().solved, verdict == Verdict::solved ? 1U : 0U) << text;
  }
}

TEST(Leaderboard, RanksBySuccessThenGapThenGapOfTheSolvedThenLabel) {
  Race race;
  race.solved("d", 0).failed("d").failed("d");  // 1/3
  race.solved("c", 0.5).solved("c", 0.5);       // all, worse gap
  race.solved("b", 0.25).solved("b", 0.25);     // all, better gap
  race.solved("f", 0.75).failed("f");           // half, no gap; worse among the solved
  race.solved("e", 0.5).failed("e");            // half, no gap
  race.failed("a");
  EXPECT_EQ(order(race.standings()), "1b 2c 3e 4f 5d 6a");
}

TEST(Leaderboard, PutsAMissingGapAfterEveryOther) {
  Race race;
  TrialRow unknown = solved_row(0, "a", "movingai/x/1");
  unknown.optimum = unknown.gap = std::nullopt;
  race.add(unknown).solved("b", 100);
  EXPECT_EQ(order(race.standings()), "1b 2a");
}

TEST(Leaderboard, SharesARankBetweenEquals) {
  Race race;
  race.solved("b", 0.5).solved("a", 0.5).solved("c", 0.75).failed("e").failed("d");
  EXPECT_EQ(order(race.standings()), "1a 1b 3c 4d 4e");
}

TEST(Leaderboard, ComparesSharesOfDifferentCountsExactly) {
  Race race;
  race.solved("a", 0.5).failed("a").failed("a");
  for (int i = 0; i < 2; ++i) race.solved("b", 0.5).failed("b").failed("b");
  EXPECT_EQ(order(race.standings()), "1a 1b");
}

TEST(Leaderboard, HasARowPerTrack) {
  Race race;
  TrialRow row = solved_row(0, "a", "dense/10-20/1");
  race.add(row);
  row.track = Track::any_angle;
  race.add(row).add(row);
  const std::vector<Standing> standings = race.standings();
  ASSERT_EQ(standings.size(), 2U);
  EXPECT_EQ(standings[0].track, Track::lattice);
  EXPECT_EQ(standings[0].trials, 1U);
  EXPECT_EQ(standings[1].track, Track::any_angle);
  EXPECT_EQ(standings[1].trials, 2U);
}

TEST(Leaderboard, RanksEachTrackFromOne) {
  Race race;
  TrialRow row = solved_row(0, "c", "dense/10-20/1");
  row.track = Track::any_angle;
  race.solved("a", 0.5).solved("b", 0.25).add(row);
  row.planner = "d";
  row.gap = 0.5;
  race.add(row).add(run_row(0, "e", "discs/open/1"));
  EXPECT_EQ(order(race.standings()), "1b 2a 1c 2d 1e");
}

TEST(Leaderboard, CountsTrialsThatGaveUpCrashedOrWereRefused) {
  Race race;
  TrialRow row = failed_row(0, "as", "dense/10-20/1");
  row.optimum = 10;
  for (const auto& [verdict, times] : {std::pair(Verdict::gave_up, 1), std::pair(Verdict::crashed, 2),
                                       std::pair(Verdict::invalid, 3), std::pair(Verdict::budget, 4)}) {
    row.verdict = verdict;
    for (int i = 0; i < times; ++i) race.add(row);
  }
  race.solved("as", 0);
  EXPECT_EQ(race.only().trials, 11U);
  EXPECT_EQ(race.only().gave_up, 1U);
  EXPECT_EQ(race.only().crashed, 2U);
  EXPECT_EQ(race.only().invalid, 3U);
}

TEST(Leaderboard, RanksRunsThroughWorldsApartFromPathsOnMaps) {
  Race race;
  race.solved("b", 0.5).failed("c").add(run_row(0, "a", "discs/open/1"));
  TrialRow lost = run_row(0, "d", "discs/open/1");
  lost.verdict = Verdict::invalid;
  lost.run->collisions = 3;
  lost.length = lost.gap = std::nullopt;
  race.add(lost);
  const std::vector<Standing> standings = race.standings();
  EXPECT_EQ(order(standings), "1b 2c 1a 2d");
  EXPECT_EQ(standings[0].steps_median, std::nullopt);
  EXPECT_EQ(standings[2].gap_median, 0.5);
  EXPECT_EQ(standings[2].steps_median, 30);
  EXPECT_EQ(standings[2].struck_mean, 1);
  EXPECT_EQ(standings[2].oscillations_median, 2);
  EXPECT_EQ(standings[2].min_clearance_median, 0.25);
  EXPECT_EQ(standings[2].step_ms_median, 0.125);
  EXPECT_EQ(standings[2].step_ms_p99_median, 0.5);
  EXPECT_EQ(standings[3].gap_median, std::nullopt);  // half or more fail: infinite
  EXPECT_EQ(standings[3].collisions_mean, 3);
  EXPECT_EQ(standings[3].steps_median, std::nullopt);
}

TEST(Leaderboard, RanksWithinEachFamily) {
  Race race;
  race.solved("a", 0.5, "trap-u/20/1").solved("b", 0.25, "trap-u/20/2");
  race.solved("a", 0.25, "dense/10-20/1").solved("b", 0.5, "dense/10-20/2");
  const std::vector<Standing> standings = race.standings(Grouping::family);
  EXPECT_EQ(order(standings), "1a 2b 1b 2a");
  EXPECT_EQ(standings[0].group, "dense/10-20");
  EXPECT_EQ(standings[3].group, "trap-u/20");
  EXPECT_EQ(order(race.standings()), "1a 1b");
}

TEST(Leaderboard, KnowsAFamilyByTheIdWithoutWhatNumbersItsQuestions) {
  EXPECT_EQ(family_of("dense/10-20/1"), "dense/10-20");
  EXPECT_EQ(family_of("discs/ring/12"), "discs/ring");
  EXPECT_EQ(family_of("trap-u/20/3"), "trap-u/20");
  EXPECT_EQ(family_of("movingai/dao/arena/7"), "movingai/dao/arena");
  EXPECT_EQ(family_of("map/office/1,2/30,4"), "map/office");
  EXPECT_EQ(family_of("map/plan 2,3/1"), "map/plan 2,3");
  EXPECT_EQ(family_of("asr/fig2"), "asr");
  EXPECT_EQ(family_of("alone"), "alone");
}

TEST(Leaderboard, CountsAPlannerThatDrawsNothingOncePerScenario) {
  Race race;
  for (const std::string scenario : {"dense/10-20/1", "dense/10-20/2"}) {
    for (const std::uint64_t repetition : {1U, 0U, 2U}) {
      TrialRow row = solved_row(0, "draws", scenario);
      row.repetition = repetition;
      row.draws = true;
      race.add(row);
      row.planner = "fixed";
      row.draws = false;
      race.add(row);
      row.planner = "unknown";
      row.draws = std::nullopt;
      race.add(row);
    }
  }
  for (const Standing& standing : race.standings()) {
    EXPECT_EQ(standing.trials, standing.planner == "fixed" ? 2U : 6U) << standing.planner;
    EXPECT_EQ(standing.success, 1);
  }
}

TEST(Leaderboard, IsCrowdedWhenOneTrialWas) {
  Race race;
  TrialRow row = solved_row(0, "a", "dense/10-20/1");
  race.add(row);
  EXPECT_FALSE(race.only().crowded);
  row.costs.crowded = true;
  race.add(row);
  EXPECT_TRUE(race.only().crowded);
}

TEST(Leaderboard, OfAnEmptyStoreIsEmpty) {
  EXPECT_TRUE(Race().standings().empty());
  EXPECT_TRUE(Race().standings(Grouping::family).empty());
}

}  // namespace
}  // namespace pathrace::results
