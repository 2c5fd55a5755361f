// Dijkstra, A* and jump point search, against the oracle.
#include "baselines/grid/grid_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <initializer_list>
#include <memory>
#include <utility>
#include <vector>

#include "baselines/grid/bucket_queue.hpp"
#include "baselines/grid/jump_point_search.hpp"
#include "baselines/grid/one_to_all.hpp"
#include "baselines/grid/ring_cost.hpp"
#include "baselines/grid/wide_bucket_queue.hpp"
#include "core/reference/exact_search.hpp"
#include "tests/support/maps.hpp"
#include "tests/support/oracle.hpp"
#include "tests/support/trials.hpp"

namespace pathrace::testing {
namespace {

class ExactSearch : public ::testing::TestWithParam<const char*> {};

TEST_P(ExactSearch, FindsTheOraclesOptimumOnRandomMapsUnderEveryRule) {
  for (std::uint64_t i = 0; i < 400; ++i) {
    const Question question = random_question(Stream(61).fork(i), 14, 0.5);
    for (const MoveRule rule : all_rules) {
      const TrialRecord record = run({GetParam()}, scenario_of(question, rule));
      const auto optimum = oracle_optimum(question.grid, rule, question.start, question.goal);
      ASSERT_EQ(record.verdict, optimum ? Verdict::solved : Verdict::no_path) << i << ' ' << name(rule);
      if (optimum) {
        ASSERT_EQ(record.metrics->lattice, optimum) << i << ' ' << name(rule);
      }
    }
  }
}

TEST_P(ExactSearch, FindsTheStatedOptimaOfTheReferenceMaps) {
  for (const ReferenceMap& map : reference_maps()) {
    for (const MoveRule rule : all_rules) {
      const TrialRecord record =
          run({GetParam()}, scenario_of({grid_of(map.rows), map.start, map.goal}, rule));
      ASSERT_EQ(record.verdict, Verdict::solved) << map.name;
      EXPECT_EQ(record.metrics->lattice, map.optimum(rule)) << map.name << ' ' << name(rule);
    }
  }
}

TEST_P(ExactSearch, StopsAtTheBudgetOfChecksExactlyAndSaysSo) {
  OccupancyGrid grid(30, 30);
  for (int y = 5; y < 28; ++y) grid.block({12, y});
  for (int y = 0; y < 22; ++y) grid.block({20, y});
  const Scenario scenario = scenario_of({grid, {0, 15}, {29, 15}});
  const std::uint64_t needed = run({GetParam()}, scenario).work.checks;
  Budget budget;
  budget.checks = needed - 1;
  const TrialRecord cut = run({GetParam(), budget}, scenario);
  EXPECT_EQ(cut.verdict, Verdict::budget);
  EXPECT_EQ(cut.work.checks, needed - 1);
  budget.checks = needed;
  EXPECT_EQ(run({GetParam(), budget}, scenario).verdict, Verdict::solved);
}

TEST_P(ExactSearch, AProofThatThereIsNoWayIsNoSpentBudget) {
  Budget one_round;
  one_round.iterations = 1;
  const Scenario scenario = scenario_of({grid_of({".#."}), {0, 0}, {2, 0}});
  EXPECT_EQ(run({GetParam(), one_round}, scenario).verdict, Verdict::no_path);
}

TEST_P(ExactSearch, MoreQueriesThanGenerationsDoNotMixUp) {
  const OccupancyGrid grid = grid_of({"....", ".##.", ".#..", "...."});
  const Terrain terrain = terrain_of(grid);
  const Entrant entrant = bench::roster().enter({GetParam(), {}});
  const auto planner = entrant.card->make(entrant.values)(terrain);
  const auto executor = bench::make_executor("serial", 1);
  const std::vector<Cell> cells = free_cells_of(grid);
  const Referee referee(terrain);
  for (std::size_t i = 0; i < 9000; ++i) {  // twelve bits of generation wrap after 4095
    const Cell start = cells[i % cells.size()];
    const Cell goal = cells[(i / cells.size()) % cells.size()];
    Meter meter({});
    Context context{Stream(1), *executor, meter};
    const Answer answer = planner->plan(start, goal, context);
    ASSERT_TRUE(answer.has_value()) << i;
    const Judgement judgement = referee.judge(*answer, start, goal);
    ASSERT_TRUE(judgement.legal()) << judgement.fault;
    ASSERT_EQ(judgement.metrics->lattice, oracle_optimum(grid, MoveRule::strict, start, goal)) << i;
  }
}

INSTANTIATE_TEST_SUITE_P(All, ExactSearch, ::testing::Values("astar", "dijkstra", "jps"));

TEST(AStar, ExpandsNoMoreCellsThanDijkstra) {
  const Scenario scenario = scenario_of({OccupancyGrid(40, 40), {5, 20}, {35, 20}});
  EXPECT_LT(run({"astar"}, scenario).work.checks, run({"dijkstra"}, scenario).work.checks / 10);
}

TEST(JumpPointSearch, ExpandsTheStartAloneWhereNoCornerIsInTheWay) {
  EXPECT_EQ(run({"jps"}, scenario_of({OccupancyGrid(200, 150), {3, 140}, {190, 20}})).work.checks, 1U);
}

TEST(JumpPointSearch, FindsTheOptimumOnMapsWiderThanAMachineWord) {
  for (std::uint64_t i = 0; i < 30; ++i) {
    Stream stream = Stream(71).fork(i);
    const double density = 0.02 + 0.01 * static_cast<double>(i);
    const OccupancyGrid grid = random_grid(stream.fork(0), 150 - static_cast<int>(i), 140, density);
    const std::vector<Cell> cells = free_cells_of(grid);
    const Cell start = cells[stream.below(cells.size())];
    const Cell goal = cells[stream.below(cells.size())];
    for (const MoveRule rule : all_rules) {
      const Scenario scenario = scenario_of({grid, start, goal}, rule);
      const TrialRecord record = run({"jps"}, scenario);
      const Optimum optimum = reference::optimum(scenario.terrain, start, goal);
      ASSERT_EQ(record.verdict, optimum.length ? Verdict::solved : Verdict::no_path) << i << name(rule);
      if (optimum.length) {
        ASSERT_EQ(record.metrics->lattice, optimum.length) << i << ' ' << name(rule);
      }
    }
  }
}

TEST(OneToAll, MeasuresTheOraclesDistances) {
  for (std::uint64_t i = 0; i < 20; ++i) {
    const Question question = random_question(Stream(73).fork(i), 9, 0.4);
    for (const MoveRule rule : all_rules) {
      const Terrain terrain = terrain_of(question.grid, rule);
      baselines::OneToAll distances(terrain);
      for (const Cell source : {question.start, question.goal}) {
        distances.measure(source);
        for (const Cell cell : free_cells_of(question.grid)) {
          ASSERT_EQ(distances.distance(cell), oracle_optimum(question.grid, rule, source, cell))
              << i << ' ' << name(rule);
        }
      }
    }
  }
}

Answer ask(MapPlanner& planner, const Question& question) {
  Meter meter({});
  const std::unique_ptr<Executor> executor = bench::make_executor("serial", 1);
  Context context{Stream(1), *executor, meter};
  return planner.plan(question.start, question.goal, context);
}

// What large maps are searched with, on small ones.
TEST(LargeRing, SearchesFindTheOraclesOptimum) {
  for (std::uint64_t i = 0; i < 60; ++i) {
    const Question question = random_question(Stream(79).fork(i), 14, 0.5);
    for (const MoveRule rule : all_rules) {
      const Terrain terrain = terrain_of(question.grid, rule);
      const auto optimum = oracle_optimum(question.grid, rule, question.start, question.goal);
      baselines::GridSearch<baselines::ZeroDistance, baselines::LargeRing> dijkstra(terrain);
      baselines::JumpPointSearch<baselines::LargeRing> jps(terrain);
      for (MapPlanner* const planner : std::initializer_list<MapPlanner*>{&dijkstra, &jps}) {
        const Answer answer = ask(*planner, question);
        ASSERT_EQ(answer.has_value(), optimum.has_value()) << i << ' ' << name(rule);
        if (!answer) continue;
        const Judgement judgement = Referee(terrain).judge(*answer, question.start, question.goal);
        ASSERT_TRUE(judgement.legal()) << judgement.fault;
        ASSERT_EQ(judgement.metrics->lattice, optimum) << i << ' ' << name(rule);
      }
    }
  }
}

// 64 - 4 - 54 = 6 bits of generation: after 63 queries the nodes are wiped.
TEST(LargeRing, AnswersAnyNumberOfQueries) {
  const Question question{OccupancyGrid(9, 7), {0, 0}, {8, 6}};
  const Terrain terrain = terrain_of(question.grid);
  baselines::GridSearch<baselines::OctileDistance, baselines::LargeRing> search(terrain);
  for (int i = 0; i < 200; ++i) {
    const Answer answer = ask(search, question);
    ASSERT_TRUE(answer.has_value()) << i;
    ASSERT_EQ(answer->points.size(), 9U) << i;
  }
}

TEST(LargeRing, GivesBackTheCountsOfSteps) {
  using baselines::LargeRing;
  for (const LatticeLength length :
       {LatticeLength{0, 0}, {1, 0}, {0, 1}, {16'000'000, 70'000'000}, {3, 89'000'000}, {134'217'728, 0}}) {
    const auto cost = static_cast<baselines::RingCost>(length.straight) * LargeRing::straight +
                      static_cast<baselines::RingCost>(length.diagonal) * LargeRing::diagonal;
    EXPECT_LT(cost, baselines::RingCost{1} << LargeRing::cost_bits);
    EXPECT_EQ(baselines::lattice_length<LargeRing>(cost), length);
  }
}

// Pell's numbers give the closest ties there are, up to the greatest counts of a map of 2^24 cells and more.
TEST(LargeRing, OrdersLikeTheExactLengthsEvenWhenTheyNearlyTie) {
  using baselines::LargeRing;
  const std::pair<baselines::RingCost, baselines::RingCost> nearly_equal[] = {
      {1393, 985}, {3'880'899, 2'744'210}, {22'619'537, 15'994'428}, {54'608'393, 38'613'965}};
  for (const auto& [straight, diagonal] : nearly_equal) {
    const bool straight_is_longer = straight * straight > 2 * diagonal * diagonal;
    EXPECT_EQ(straight * LargeRing::straight > diagonal * LargeRing::diagonal, straight_is_longer);
    EXPECT_NE(straight * LargeRing::straight, diagonal * LargeRing::diagonal);
  }
}

TEST(RingCost, GivesBackTheCountsOfSteps) {
  for (const LatticeLength length : {LatticeLength{0, 0},
                                     {1, 0},
                                     {0, 1},
                                     {1393, 985},
                                     {16'000'000, 0},
                                     {3, 15'994'427},
                                     {8'000'000, 7'000'000}}) {
    const auto cost = static_cast<baselines::RingCost>(length.straight) * baselines::straight_cost +
                      static_cast<baselines::RingCost>(length.diagonal) * baselines::diagonal_cost;
    EXPECT_EQ(baselines::lattice_length(cost), length);
  }
}

TEST(RingCost, OrdersLikeTheExactLengthsEvenWhenTheyNearlyTie) {
  // Pell's numbers give the closest ties there are: 1393 and 985 sqrt 2 differ by 0.00036.
  const std::pair<std::int64_t, std::int64_t> nearly_equal[] = {
      {577, 408}, {1393, 985}, {3363, 2378}, {8119, 5741}};
  for (const auto& [straight, diagonal] : nearly_equal) {
    for (std::int64_t extra = 0; extra < 3; ++extra) {
      const LatticeLength a{straight + extra, extra};
      const LatticeLength b{extra, diagonal + extra};
      const auto cost = [](LatticeLength length) {
        return static_cast<baselines::RingCost>(length.straight) * baselines::straight_cost +
               static_cast<baselines::RingCost>(length.diagonal) * baselines::diagonal_cost;
      };
      EXPECT_EQ(cost(a) < cost(b), sign_of(a.straight - b.straight, a.diagonal - b.diagonal) < 0);
    }
  }
}

// Pushes like a search, up to `rise` above what was popped: costs never fall back by a bucket's width.
template <typename Queue>
void expect_order(Queue& queue, baselines::RingCost rise, bool (*more)(Queue&)) {
  queue.restart(0);
  queue.push(0, 0);
  Stream stream(67);
  baselines::RingCost last = 0;
  std::vector<baselines::RingCost> cost_of{0};
  std::vector<bool> popped;
  int i = 0;
  for (; i < 20000 && more(queue); ++i) {
    const std::uint32_t entry = queue.pop();
    const baselines::RingCost cost = cost_of[entry];
    popped.resize(cost_of.size());
    ASSERT_FALSE(popped[entry]);
    popped[entry] = true;
    ASSERT_GE(cost + (1U << 23), last);
    last = std::max(last, cost);
    for (std::uint64_t k = i < 5 ? 3 : stream.below(3); k > 0; --k) {
      cost_of.push_back(cost + stream.below(rise));
      queue.push(cost_of.back(), static_cast<std::uint32_t>(cost_of.size() - 1));
    }
  }
  EXPECT_GT(i, 100);
}

TEST(BucketQueue, ReturnsCostsInOrderUpToTheBucketsWidth) {
  baselines::BucketQueue<> queue;
  expect_order<baselines::BucketQueue<>>(queue, 2 * baselines::diagonal_cost,
                                         [](baselines::BucketQueue<>& q) { return q.advance(); });
}

TEST(WideBucketQueue, ReturnsCostsInOrderUpToTheBucketsWidth) {
  const baselines::RingCost rise = 500 * baselines::diagonal_cost;
  baselines::WideBucketQueue<> queue(rise);
  expect_order<baselines::WideBucketQueue<>>(queue, rise,
                                             [](baselines::WideBucketQueue<>& q) { return !q.empty(); });
}

}  // namespace
}  // namespace pathrace::testing
