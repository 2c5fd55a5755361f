// Features on maps drawn by hand, with values from arithmetic.
#include "bench/features/feature.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>

#include "tests/support/trials.hpp"

namespace pathrace::bench {
namespace {

using testing::grid_of;

Scenario scenario_of(const std::vector<std::string>& rows, Cell start, Cell goal,
                     MoveRule rule = MoveRule::strict) {
  return testing::scenario_of({grid_of(rows), start, goal}, rule);
}

std::optional<double> value(const std::string& feature_name, const Scenario& scenario) {
  FeatureContext context(scenario);
  for (const Feature& feature : features()) {
    if (feature.name == feature_name) return feature.compute(context);
  }
  throw std::invalid_argument("no feature " + feature_name);
}

const std::vector<std::string> corridor = {"....."};
const std::vector<std::string> no_way = {"..#."};

TEST(Features, HaveNamesOfTheirOwnThatSuitAColumnAndSayWhatTheyMean) {
  std::set<std::string_view> names;
  for (const Feature& feature : features()) {
    EXPECT_TRUE(names.insert(feature.name).second) << feature.name;
    EXPECT_EQ(feature.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_"), std::string_view::npos)
        << feature.name;
    EXPECT_FALSE(feature.unit.empty()) << feature.name;
    EXPECT_FALSE(feature.meaning.empty()) << feature.name;
  }
}

TEST(Features, AreComputedAllAtOnceInTheOrderOfTheList) {
  const Scenario scenario = scenario_of({"...", ".#.", "..."}, {0, 0}, {2, 2});
  const auto values = compute_features(scenario);
  ASSERT_EQ(values.size(), features().size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    EXPECT_EQ(values[i], value(std::string(features()[i].name), scenario)) << features()[i].name;
    if (features()[i].type == FeatureType::integer) {
      EXPECT_EQ(std::floor(*values[i]), *values[i]);
    }
  }
}

TEST(Features, DensityIsTheBlockedShare) {
  EXPECT_EQ(value("density", scenario_of({"..", ".#", ".."}, {0, 0}, {0, 2})), 1.0 / 6);
  EXPECT_EQ(value("density", scenario_of(corridor, {0, 0}, {4, 0})), 0);
}

TEST(Features, DetourIsTheOptimumOverTheStraightLine) {
  const std::vector<std::string> wall = {"...", "##.", "..."};
  // Around the corner: 2 + 2 + 2 steps for a distance of 2; cutting it saves two steps of 2 - sqrt 2 each.
  EXPECT_EQ(value("detour", scenario_of(wall, {0, 0}, {0, 2})), 3);
  EXPECT_DOUBLE_EQ(value("detour", scenario_of(wall, {0, 0}, {0, 2}, MoveRule::free)).value(),
                   1 + std::sqrt(2.0));
  EXPECT_EQ(value("detour", scenario_of(corridor, {2, 0}, {2, 0})), std::nullopt);
  EXPECT_EQ(value("detour", scenario_of(no_way, {0, 0}, {3, 0})), std::nullopt);
}

TEST(Features, ExpansionsAreTheCellsThatAStarExpands) {
  EXPECT_EQ(value("expansions", scenario_of(corridor, {0, 0}, {4, 0})), 4);  // all but the goal
  EXPECT_EQ(value("expansions", scenario_of(corridor, {2, 0}, {2, 0})), 0);
  EXPECT_EQ(value("expansions", scenario_of(no_way, {0, 0}, {3, 0})), 2);  // all that can be reached
}

TEST(Features, OptimalPathsAreCountedUnderTheScenariosRule) {
  const std::vector<std::string> open = {"...", "...", "..."};
  // Two steps right, one of them diagonal: 2 ways. Under `four` three steps, one of them down: 3 ways.
  EXPECT_NEAR(value("optimal_paths_log10", scenario_of(open, {0, 0}, {2, 1})).value(), std::log10(2.0),
              1e-15);
  EXPECT_NEAR(value("optimal_paths_log10", scenario_of(open, {0, 0}, {2, 1}, MoveRule::four)).value(),
              std::log10(3.0), 1e-15);
  EXPECT_EQ(value("optimal_paths_log10", scenario_of(open, {1, 1}, {1, 1})), 0);
  EXPECT_EQ(value("optimal_paths_log10", scenario_of(no_way, {0, 0}, {3, 0})), std::nullopt);
}

TEST(Features, DeadEndsAreBlindAlleysUpToTheirMouths) {
  const std::vector<std::string> alley = {".....", "##.##", "##.##"};
  // 7 free cells; the alley of 2 is blind. Without corner rules its upper cell sees three cells: only the
  // lower one goes.
  EXPECT_EQ(value("dead_end_share", scenario_of(alley, {0, 0}, {4, 0})), 2.0 / 7);
  EXPECT_EQ(value("dead_end_share", scenario_of(alley, {0, 0}, {4, 0}, MoveRule::free)), 1.0 / 7);
}

TEST(Features, DeadEndsNeverTakeStartOrGoal) {
  EXPECT_EQ(value("dead_end_share", scenario_of(corridor, {0, 0}, {4, 0})), 0);
  EXPECT_EQ(value("dead_end_share", scenario_of(corridor, {2, 0}, {3, 0})), 3.0 / 5);
  EXPECT_EQ(value("dead_end_share", scenario_of({"..."}, {1, 0}, {1, 0})), 2.0 / 3);
  EXPECT_EQ(value("dead_end_share", scenario_of(no_way, {0, 0}, {1, 0})), 1.0 / 3);  // a cell without steps
}

TEST(Features, DeadEndsLeaveRingsAlone) {
  EXPECT_EQ(value("dead_end_share", scenario_of({"...", ".#.", "..."}, {0, 0}, {0, 1}, MoveRule::four)), 0);
}

TEST(Features, TrapDepthIsTheLongestRetreatOfAGreedyWalk) {
  const std::vector<std::string> pocket = {"......",  //
                                           ".####.",  //
                                           "....#."};
  // From (0,2) greed leads right to (3,2); the way out begins three cells back.
  EXPECT_EQ(value("trap_depth", scenario_of(pocket, {0, 2}, {5, 2}, MoveRule::four)), 3);
  EXPECT_EQ(value("trap_depth", scenario_of(corridor, {0, 0}, {4, 0})), 0);
  EXPECT_EQ(value("trap_depth", scenario_of(corridor, {2, 0}, {2, 0})), 0);
  EXPECT_EQ(value("trap_depth", scenario_of(no_way, {0, 0}, {3, 0})), std::nullopt);
}

TEST(Features, TrapDepthCountsRunsNotTheirSum) {
  // Two pockets of two cells each, entered one after the other: (2,2), (3,2), then (7,2), (8,2).
  const std::vector<std::string> pockets = {"...........",  //
                                            ".####.####.",  //
                                            "...##...##."};
  EXPECT_EQ(value("trap_depth", scenario_of(pockets, {0, 2}, {10, 2}, MoveRule::four)), 2);
}

TEST(Features, TrapDepthBreaksTiesByTheFirstDirection) {
  // Right and down are equally near to the goal (2,2): right is tried first, in vain or not.
  EXPECT_EQ(value("trap_depth", scenario_of({"..#", ".##", "..."}, {0, 0}, {2, 2}, MoveRule::four)), 1);
  EXPECT_EQ(value("trap_depth", scenario_of({"...", ".#.", "##."}, {0, 0}, {2, 2}, MoveRule::four)), 0);
}

TEST(Features, ClearanceIsMeasuredAlongAnOptimalPath) {
  // Along the middle row the frame is 1, 2, 2, 2 and 1 cells away.
  const Scenario hall = scenario_of({".....", ".....", "....."}, {0, 1}, {4, 1});
  EXPECT_EQ(value("clearance_min", hall), 1);
  EXPECT_EQ(value("clearance_mean", hall), 8.0 / 5);
  EXPECT_EQ(value("clearance_min", scenario_of(no_way, {0, 0}, {3, 0})), std::nullopt);
  EXPECT_EQ(value("clearance_mean", scenario_of(no_way, {0, 0}, {3, 0})), std::nullopt);
}

TEST(Features, ArrivalIsCertainWhereThereIsOneWayAndImpossibleWhereThereIsNone) {
  EXPECT_EQ(value("arrival_rate", scenario_of(corridor, {0, 0}, {4, 0})), 1);
  EXPECT_EQ(value("arrival_rate", scenario_of(corridor, {2, 0}, {2, 0})), 1);
  EXPECT_EQ(value("arrival_rate", scenario_of(no_way, {0, 0}, {3, 0})), 0);
}

// How far a share of n walks may lie from the share p of 1500 that is published: four standard errors. A
// share of exactly 0 or 1 has one too: what rounding to three digits may hide.
double four_standard_errors(double p, double n) {
  const double kept = std::clamp(p, 0.002, 0.998);
  return 4 * std::sqrt(kept * (1 - kept) * (1 / n + 1.0 / 1500));
}

TEST(Features, ArrivalFollowsTheHeuristicAtAFork) {
  // From the middle of a blind corridor, the goal 9 cells from the one neighbour and 11 from the other: with
  // 1 / distance to the seventh power, 1 / (1 + (9/11)^7) = 0.803 of the ants turn the right way.
  const Scenario fork = scenario_of({std::string(21, '.')}, {10, 0}, {20, 0});
  EXPECT_NEAR(value("arrival_rate", fork).value(), 0.803, four_standard_errors(0.803, 200));
}

TEST(Features, ArrivalRatesAreThePublishedOnes) {
  const std::map<std::string, std::pair<double, double>> free_and_strict = {
      {"asr/fig2", {1, 0.975}},
      {"asr/fig5", {1, 0.999}},
      {"asr/fig6", {1, 0.996}},
      {"curated/trap-l-20", {0.281, 0.261}},
      {"curated/trap-u-east-20", {0.045, 0.033}},
      {"curated/trap-hook-20", {0.133, 0.141}},
      {"curated/trap-nested-l-20", {0.085, 0.071}},
      {"curated/trap-baffle-20", {0, 0}},
      {"curated/trap-comb-20", {0.055, 0.045}},
      {"curated/trap-tunnel-20", {0.129, 0.105}},
      {"curated/trap-spiral-20", {0.019, 0.009}},
      {"curated/trap-pocket-10", {0.959, 0.935}},
  };
  for (const testing::ReferenceMap& map : testing::reference_maps()) {
    const auto& [free, strict] = free_and_strict.at(map.name);
    for (const auto& [rule, rate] : {std::pair{MoveRule::free, free}, std::pair{MoveRule::strict, strict}}) {
      Scenario scenario = scenario_of(map.rows, map.start, map.goal, rule);
      scenario.id = map.name;
      EXPECT_NEAR(value("arrival_rate", scenario).value(), rate, four_standard_errors(rate, 200))
          << map.name << " " << name(rule);
    }
  }
}

TEST(Features, ArrivalBelongsToTheScenariosIdAndToMapsOfModestSize) {
  const testing::ReferenceMap& trap = testing::reference_maps()[3];
  Scenario scenario = scenario_of(trap.rows, trap.start, trap.goal);
  const auto first = value("arrival_rate", scenario);
  EXPECT_EQ(value("arrival_rate", scenario), first);
  std::set<std::optional<double>> rates;
  for (int i = 0; i < 8; ++i) {
    scenario.id = "another/" + std::to_string(i);
    rates.insert(value("arrival_rate", scenario));
  }
  EXPECT_GT(rates.size(), 1U);  // eight draws of 200 walks at a rate of a quarter do not all agree
  const testing::Question huge{OccupancyGrid(513, 512), {0, 0}, {512, 511}};
  EXPECT_EQ(value("arrival_rate", testing::scenario_of(huge)), std::nullopt);
}

TEST(Features, DoNotNeedAProvenOptimum) {
  Scenario scenario = scenario_of({"...", "##.", "..."}, {0, 0}, {0, 2});
  const auto unproven = compute_features(scenario);
  scenario.optimum = {true, LatticeLength{6, 0}};
  EXPECT_EQ(compute_features(scenario), unproven);
}

}  // namespace
}  // namespace pathrace::bench
