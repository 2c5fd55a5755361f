// The genetic algorithm's operators, one at a time, on maps small enough to work them out by hand.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "algorithms/ga/crossover.hpp"
#include "algorithms/ga/fitness.hpp"
#include "algorithms/ga/gene_map.hpp"
#include "algorithms/ga/loop_free_path.hpp"
#include "algorithms/ga/mutation.hpp"
#include "algorithms/ga/random_chromosome.hpp"
#include "tests/support/maps.hpp"
#include "tests/support/oracle.hpp"

namespace pathrace::testing {
namespace {

using namespace algorithms;  // NOLINT(google-build-using-namespace): the operators under test

const std::vector<std::string> open_5x5 = {".....", ".....", ".....", ".....", "....."};

Problem corner_to_corner(const OccupancyGrid& grid, MoveRule rule = MoveRule::strict) {
  return {grid, rule, {0, 0}, {grid.width() - 1, grid.height() - 1}};
}

// The paper numbers cells row by row from 0.
std::vector<Gene> genes_of(const OccupancyGrid& grid, const std::vector<int>& numbers) {
  std::vector<Gene> genes;
  for (const int k : numbers) {
    genes.push_back(static_cast<Gene>(grid.index({k % grid.width(), k / grid.width()})));
  }
  return genes;
}

std::vector<Gene> without_loops(const std::vector<Gene>& genes, std::size_t capacity) {
  PlaceTable places(1000);
  LoopFreePath path(places);
  std::vector<Gene> slot(capacity);
  path.open(slot);
  for (const Gene gene : genes) {
    if (!path.append(gene)) return {};
  }
  return {path.genes().begin(), path.genes().end()};
}

TEST(GaFitness, IsThePapersFormulaOnItsPaths) {
  // Length in cm, cells, f as algorithms.md 5.1 has them: (1 + 1 / sqrt(n + 1)) D.
  struct Row {
    std::size_t cells;
    double straight, diagonal, f;
  };
  for (const Row& row :
       {Row{5, 0, 4, 398.3}, {6, 2, 3, 430.1}, {7, 4, 2, 462.1}, {8, 6, 1, 494.3}, {9, 8, 0, 526.5}}) {
    EXPECT_NEAR(fitness(row.cells, 50 * (row.straight + row.diagonal * std::numbers::sqrt2)), row.f, 0.06);
  }
  EXPECT_NEAR(fitness(2, 50 * std::sqrt(32.0)), 446.1, 0.06);  // start and goal with nothing between
}

TEST(GaFitness, MeasuresStepsExactlyAndGapsAsTheCrowFlies) {
  const OccupancyGrid grid = grid_of(open_5x5);
  const GeneMap map(corner_to_corner(grid));
  const std::vector<Gene> path = genes_of(grid, {0, 6, 11, 12, 8, 7});  // SE, S, E, NE, W
  EXPECT_EQ(step_counts(path, map.stride()), (LatticeLength{3, 2}));
  EXPECT_NEAR(straight_distances(map, path), 3 + 2 * std::numbers::sqrt2, 1e-12);
  EXPECT_NEAR(straight_distances(map, genes_of(grid, {0, 4, 24, 12})), 8 + 2 * std::numbers::sqrt2, 1e-12);
  EXPECT_EQ(step_counts(genes_of(grid, {0}), map.stride()), (LatticeLength{0, 0}));
}

TEST(GaGeneMap, KnowsDirectionsAndLegalStepsOfAllPairsOfCells) {
  for (const MoveRule rule : all_rules) {
    for (const auto& [width, height] : {std::pair{1, 5}, {5, 1}, {2, 6}, {7, 6}}) {
      const OccupancyGrid grid =
          random_grid(Stream(5).fork(static_cast<std::uint64_t>(width)), width, height, 0.2);
      const std::vector<Cell> cells = free_cells_of(grid);
      const GeneMap map({grid, rule, cells.front(), cells.back()});
      for (const Cell a : cells) {
        for (const Cell b : cells) {
          const Gene from = static_cast<Gene>(grid.index(a));
          const Gene to = static_cast<Gene>(grid.index(b));
          int expected = -1;
          for (int d = 0; d < direction_count; ++d) {
            const Cell step = directions[static_cast<std::size_t>(d)];
            if (b == Cell{a.x + step.x, a.y + step.y}) expected = d;
          }
          EXPECT_EQ(map.direction(from, to), expected);
          EXPECT_EQ(map.linked(from, to), expected >= 0 && oracle_step(grid, rule, a, b));
          EXPECT_EQ(map.cell(from), a);
        }
      }
    }
  }
}

TEST(GaDeletion, CutsWhatLiesBetweenEqualGenesAndOneOfThem) {
  using Genes = std::vector<Gene>;
  EXPECT_EQ(without_loops({1, 2, 3}, 9), (Genes{1, 2, 3}));
  EXPECT_EQ(without_loops({1, 2, 3, 2, 4}, 9), (Genes{1, 2, 4}));
  EXPECT_EQ(without_loops({1, 1, 1, 2}, 9), (Genes{1, 2}));
  EXPECT_EQ(without_loops({1, 2, 3, 1, 4, 2, 5}, 9),
            (Genes{1, 4, 2, 5}));  // 2 comes back after 1's loop went
  EXPECT_EQ(without_loops({1, 2, 3, 4, 2, 5, 3, 6}, 9), (Genes{1, 2, 5, 3, 6}));
  EXPECT_EQ(without_loops({1, 2, 3, 4, 1}, 9), (Genes{1}));
}

TEST(GaDeletion, IsTheEarliestStartWithTheLongestCutRepeated) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    Stream stream(seed);
    std::vector<Gene> genes;
    for (int i = 0; i < 40; ++i) genes.push_back(static_cast<Gene>(stream.below(12)));
    std::vector<Gene> expected;  // jump to the last place of each cell
    for (std::size_t i = 0; i < genes.size(); ++i) {
      for (std::size_t j = i; j < genes.size(); ++j) {
        if (genes[j] == genes[i]) i = j;
      }
      expected.push_back(genes[i]);
    }
    EXPECT_EQ(without_loops(genes, 40), expected) << seed;
  }
}

TEST(GaDeletion, TellsWhenTheSlotIsFull) {
  EXPECT_TRUE(without_loops({1, 2, 3, 4}, 3).empty());
  EXPECT_EQ(without_loops({1, 2, 3, 2, 4}, 3), (std::vector<Gene>{1, 2, 4}));  // a loop gives its room back
}

TEST(GaDeletion, FollowsLegalStepsToNewCellsOnly) {
  const OccupancyGrid grid = grid_of({".....", ".....", "..#..", ".....", "....."});
  const GeneMap map(corner_to_corner(grid));
  const auto followed = [&](const std::vector<int>& numbers, std::size_t capacity) {
    const std::vector<Gene> genes = genes_of(grid, numbers);
    PlaceTable places(map.size());
    LoopFreePath path(places);
    std::vector<Gene> slot(capacity);
    path.open(slot);
    path.append(genes.front());
    const std::size_t count = path.follow(map, std::span<const Gene>(genes).subspan(1));
    EXPECT_EQ(path.size(), 1 + count);
    return count;
  };
  EXPECT_EQ(followed({0, 6, 7, 8, 14}, 9), 4U);
  EXPECT_EQ(followed({0, 6, 8, 14}, 9), 1U);          // 7 is missing
  EXPECT_EQ(followed({0, 6, 7, 13, 14}, 9), 2U);      // the step from 7 to 13 passes the corner of 12
  EXPECT_EQ(followed({0, 6, 7, 2, 1, 6, 5}, 9), 4U);  // 6 again
  EXPECT_EQ(followed({0, 6, 7, 8, 14}, 3), 2U);       // full
}

std::set<std::pair<std::size_t, std::size_t>> cuts(CrossoverPoint point, const std::vector<Gene>& first,
                                                   const std::vector<Gene>& second) {
  PlaceTable places(1000);
  Crossover crossover(places, point);
  std::set<std::pair<std::size_t, std::size_t>> seen;
  Stream stream(3);
  for (int i = 0; i < 2000; ++i) {
    const auto cut = crossover.cut(first, second, stream);
    if (cut) seen.insert({cut->first, cut->second});
  }
  return seen;
}

TEST(GaCrossover, CutsAtEachInnerCellThatBothParentsVisit) {
  using Cuts = std::set<std::pair<std::size_t, std::size_t>>;
  EXPECT_EQ(cuts(CrossoverPoint::common, {0, 6, 12, 18, 24}, {0, 1, 2, 7, 12, 13, 19, 24}), (Cuts{{2, 4}}));
  EXPECT_EQ(cuts(CrossoverPoint::common, {0, 6, 12, 18, 24}, {0, 18, 5, 6, 24}), (Cuts{{1, 3}, {3, 1}}));
}

TEST(GaCrossover, CutsAnywhereInsideWhenNothingIsShared) {
  const std::vector<Gene> first = {0, 6, 12, 18, 24};
  const std::vector<Gene> second = {0, 1, 2, 3, 4, 9, 14, 19, 24};
  EXPECT_EQ(cuts(CrossoverPoint::common, first, second).size(), 3U * 7U);
  EXPECT_EQ(cuts(CrossoverPoint::free, first, first).size(), 3U * 3U);
  EXPECT_TRUE(cuts(CrossoverPoint::common, {0, 24}, second).empty());
  EXPECT_TRUE(cuts(CrossoverPoint::free, second, {0, 24}).empty());
}

TEST(GaMutation, ReplacesOneInnerGeneByAFreeCell) {
  const OccupancyGrid grid = grid_of({"...", ".#.", "..."});
  const GeneMap map(corner_to_corner(grid));
  const std::vector<Gene> before = genes_of(grid, {0, 1, 5, 8});
  std::set<std::vector<Gene>> seen;
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    std::vector<Gene> genes = before;
    Stream stream(seed);
    mutate(map, Mutation::replace, stream, genes);
    seen.insert(genes);
  }
  // Each of two places may hold each of the six inner cells; the chromosome itself comes up in both.
  EXPECT_EQ(seen.size(), 6U + 6U - 1U);
  for (const std::vector<Gene>& genes : seen) {
    EXPECT_EQ(genes.front(), before.front());
    EXPECT_EQ(genes.back(), before.back());
  }
}

TEST(GaMutation, AStretchIsReplacedByOneFreeCellOrNone) {
  const OccupancyGrid grid = grid_of({".....", ".###.", ".....", ".....", "....."});
  const GeneMap map(corner_to_corner(grid));
  const std::vector<Gene> before = genes_of(grid, {0, 1, 2, 3, 4, 9, 14, 19, 24});
  std::set<std::size_t> sizes;
  for (std::uint64_t seed = 0; seed < 20000; ++seed) {
    std::vector<Gene> genes = before;
    Stream stream(seed);
    mutate(map, Mutation::stretch, stream, genes);
    std::size_t head = 0;
    while (head < genes.size() && genes[head] == before[head]) ++head;
    std::size_t tail = 0;
    while (tail < genes.size() - head && genes[genes.size() - 1 - tail] == before[before.size() - 1 - tail])
      ++tail;
    EXPECT_GE(head, 1U);
    EXPECT_LE(genes.size(), head + tail + 1);
    if (genes != before) {
      EXPECT_GE(tail, 1U);
    }
    for (const Gene gene : genes) EXPECT_TRUE(grid.is_free(grid.cell(gene)));
    sizes.insert(genes.size());
  }
  EXPECT_EQ(*sizes.begin(), 2U);
  EXPECT_EQ(*sizes.rbegin(), 9U);
}

TEST(GaMutation, LeavesStartAndGoalAlone) {
  const OccupancyGrid grid = grid_of(open_5x5);
  const GeneMap map(corner_to_corner(grid));
  for (const Mutation kind : {Mutation::replace, Mutation::stretch}) {
    std::vector<Gene> genes = {map.start(), map.goal()};
    Stream stream(1);
    mutate(map, kind, stream, genes);
    EXPECT_EQ(genes, (std::vector<Gene>{map.start(), map.goal()}));
  }
}

TEST(GaRandomChromosome, HasDifferentFreeCellsBetweenStartAndGoal) {
  const OccupancyGrid grid = grid_of({"....", ".##.", "...."});  // 8 inner cells
  const GeneMap map(corner_to_corner(grid));
  RandomChromosome random(map, 0);
  std::set<std::size_t> sizes;
  std::set<Gene> second;
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    Stream stream(seed);
    std::vector<Gene> genes;
    random.draw(stream, genes);
    EXPECT_EQ(genes.front(), map.start());
    EXPECT_EQ(genes.back(), map.goal());
    EXPECT_EQ(std::set<Gene>(genes.begin(), genes.end()).size(), genes.size());
    for (const Gene gene : genes) EXPECT_TRUE(grid.is_free(grid.cell(gene)));
    sizes.insert(genes.size());
    if (genes.size() > 2) second.insert(genes[1]);
  }
  EXPECT_EQ(sizes.size(), 9U);  // 0 to 8 inner genes
  EXPECT_EQ(second.size(), 8U);
}

TEST(GaRandomChromosome, DoesNotDependOnWhatWasDrawnBefore) {
  const OccupancyGrid grid = grid_of(open_5x5);
  const GeneMap map(corner_to_corner(grid));
  RandomChromosome used(map, 6);
  std::vector<Gene> genes;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    Stream stream(seed);
    used.draw(stream, genes);
    EXPECT_LE(genes.size(), 8U);
    std::vector<Gene> expected;
    Stream again(seed);
    RandomChromosome(map, 6).draw(again, expected);
    EXPECT_EQ(genes, expected);
  }
}

}  // namespace
}  // namespace pathrace::testing
