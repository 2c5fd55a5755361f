#include "results/row.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "core/error.hpp"
#include "tests/results/rows.hpp"
#include "tests/support/maps.hpp"

namespace pathrace::results {
namespace {

using pathrace::testing::grid_of;
using pathrace::testing::terrain_of;

/// A trial on a free 3x2 map: one straight and one diagonal step, where the optimum is a diagonal and a
/// straight.
struct Trial {
  PlannerCard card;
  Entrant entrant;
  Scenario scenario;
  TrialKey key;
  Budget budget;
  TrialRecord record;

  Trial() {
    card.name = "as";
    card.version = 4;
    card.track = Track::lattice;
    entrant.card = &card;
    entrant.values = {{"alpha", "1"}, {"ants", "20"}};
    entrant.label = "as:ants=20";
    scenario.id = "dense/3-0/1";
    scenario.terrain = terrain_of(grid_of({"...", "..."}), MoveRule::squeeze);
    scenario.goal = {2, 1};
    scenario.optimum = {true, LatticeLength{1, 1}};
    key = {scenario.id, content_hash(scenario), entrant.full_call(), 4, 3, 99, 0};
    budget.evaluations = 50;
    record.key = key.hash();
    record.verdict = Verdict::solved;
    record.note = "a note";
    record.answer = lattice_path({{0, 0}, {0, 1}, {1, 1}, {2, 1}});
    PathMetrics metrics;
    metrics.length = 3;
    metrics.lattice = LatticeLength{3, 0};
    metrics.turns = 1;
    metrics.turn_angle = std::numbers::pi / 2;
    metrics.clearance_min = 1;
    metrics.clearance_mean = 1.25;
    record.metrics = metrics;
    record.work = {50, 5, 800};
    record.trace = {{{10, 1, 100}, 0.25, 3}};
    record.timed = true;
    record.costs = {0.5, 0.125, "tbb", 2, 1, true, {}, {}, {}, {}};
  }
  TrialRow row() const { return make_row(key, scenario, entrant, budget, record); }
};

TEST(Row, SaysWhatWasAskedAndWhatCameOut) {
  const Trial trial;
  const TrialRow row = trial.row();
  EXPECT_EQ(row.key, trial.key.hash());
  EXPECT_EQ(row.scenario, "dense/3-0/1");
  EXPECT_EQ(row.planner, "as:ants=20");
  EXPECT_EQ(row.call, "as:alpha=1,ants=20");
  EXPECT_EQ(row.version, 4);
  EXPECT_EQ(row.repetition, 3U);
  EXPECT_EQ(row.seed, 99U);
  EXPECT_EQ(row.budget, "evaluations=50");
  EXPECT_EQ(row.verdict, Verdict::solved);
  EXPECT_EQ(row.note, "a note");
  EXPECT_EQ(row.track, Track::lattice);
  EXPECT_EQ(row.rule, MoveRule::squeeze);
  EXPECT_EQ(row.length, 3);
  EXPECT_DOUBLE_EQ(row.optimum.value(), 1 + std::numbers::sqrt2);
  EXPECT_DOUBLE_EQ(row.gap.value(), 3 / (1 + std::numbers::sqrt2) - 1);
  EXPECT_EQ(row.turns, 1);
  EXPECT_EQ(row.turn_angle, std::numbers::pi / 2);
  EXPECT_EQ(row.clearance_min, 1);
  EXPECT_EQ(row.clearance_mean, 1.25);
  EXPECT_EQ(row.work, (Work{50, 5, 800}));
  EXPECT_EQ(row.digest, digest(trial.record));
  EXPECT_TRUE(row.timed);
  EXPECT_EQ(row.costs.wall_s, 0.5);
  EXPECT_EQ(row.costs.backend, "tbb");
  EXPECT_TRUE(row.costs.crowded);
  EXPECT_EQ(row.answer, trial.record.answer);
  ASSERT_EQ(row.trace.size(), 1U);
  EXPECT_EQ(row.trace[0].work, (Work{10, 1, 100}));
}

TEST(Row, HasMetricsOfSolvedTrialsOnlyButKeepsARefusedPath) {
  Trial trial;
  trial.record.verdict = Verdict::invalid;
  const TrialRow row = trial.row();
  EXPECT_FALSE(row.length || row.gap || row.turns || row.turn_angle || row.clearance_min ||
               row.clearance_mean);
  EXPECT_TRUE(row.optimum.has_value());
  EXPECT_EQ(row.answer, trial.record.answer);
}

TEST(Row, CountsItsGapFromTheOptimumOfItsTrack) {
  Trial trial;
  trial.card.track = Track::any_angle;
  trial.scenario.any_angle_optimum = {true, 2.4};
  trial.record.metrics->lattice.reset();
  const TrialRow row = trial.row();
  EXPECT_EQ(row.optimum, 2.4);
  EXPECT_DOUBLE_EQ(row.gap.value(), 0.25);  // 3 / 2.4 - 1
  trial.record.verdict = Verdict::budget;
  EXPECT_EQ(trial.row().optimum, 2.4);
  trial.scenario.any_angle_optimum.length.reset();
  EXPECT_EQ(trial.row().optimum, std::nullopt);
}

TEST(Row, HasNoGapWithoutAReference) {
  Trial trial;
  trial.scenario.optimum = {};
  EXPECT_FALSE(trial.row().optimum || trial.row().gap);
  EXPECT_EQ(trial.row().length, 3);
}

TEST(Row, AddsUpToItsOwnDigestUntilItIsAltered) {
  const Trial trial;
  const TrialRow row = trial.row();
  EXPECT_EQ(recomputed_digest(row), row.digest);

  TrialRow altered = row;
  altered.answer->points[1].x += 1e-15;
  EXPECT_NE(recomputed_digest(altered), row.digest);
  altered = row;
  altered.verdict = Verdict::no_path;
  EXPECT_NE(recomputed_digest(altered), row.digest);
  altered = row;
  altered.answer.reset();
  EXPECT_NE(recomputed_digest(altered), row.digest);
  altered = row;
  ++altered.work.checks;
  EXPECT_NE(recomputed_digest(altered), row.digest);
  altered = row;
  altered.trace[0].cost = 2.5;
  EXPECT_NE(recomputed_digest(altered), row.digest);

  altered = row;  // costs are not part of it
  altered.trace[0].wall_s = 9;
  altered.costs.wall_s = 9;
  EXPECT_EQ(recomputed_digest(altered), row.digest);
}

TEST(Points, ArePrintedInShortestDecimals) {
  EXPECT_EQ(print_points(lattice_path({{0, 0}, {1, 1}, {2, 1}})), "0,0 1,1 2,1");
  EXPECT_EQ(print_points({Track::any_angle, {{0.5, -1.25}}}), "0.5,-1.25");
  EXPECT_EQ(print_points({}), "");
}

TEST(Points, ReadBack) {
  EXPECT_EQ(parse_points("0,0 1,1 2.5,1"), (std::vector<Point>{{0, 0}, {1, 1}, {2.5, 1}}));
  EXPECT_TRUE(parse_points("").empty());
  for (const char* text : {" ", "0", "0,", ",0", "0,0 ", " 0,0", "0,0  1,1", "0,0,0", "0,0;1,1", "a,b"}) {
    EXPECT_THROW(parse_points(text), InputError) << text;
  }
}

}  // namespace
}  // namespace pathrace::results
