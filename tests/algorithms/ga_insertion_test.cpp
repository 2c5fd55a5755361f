// The genetic algorithm's insertion operator and its detours, worked out by hand.
#include <gtest/gtest.h>

#include <optional>
#include <set>
#include <vector>

#include "algorithms/ga/insertion.hpp"
#include "tests/support/maps.hpp"

namespace pathrace::testing {
namespace {

using namespace algorithms;  // NOLINT(google-build-using-namespace): the operator under test

const std::vector<std::string> open_5x5 = {".....", ".....", ".....", ".....", "....."};
const std::vector<std::string> fig5 = {".....", "...#.", ".#...", ".....", "....."};
const std::vector<std::string> fig6 = {".....", "..#..", ".....", "..#..", "....."};

struct Insert {
  std::vector<std::string> rows;
  Insertion rule = Insertion::faithful;
  GapRepair repair = GapRepair::none;
  MoveRule moves = MoveRule::strict;
  std::size_t reach = 100;
  std::uint64_t limit = 1000;
  std::uint64_t seed = 1;

  mutable Inserter::Outcome outcome = Inserter::Outcome::deleted;
  mutable std::uint64_t checks = 0;

  /// Cells are numbered row by row, as in the paper. Nothing when the individual is deleted or cut.
  std::optional<std::vector<int>> fill(const std::vector<int>& numbers) const {
    const OccupancyGrid grid = grid_of(rows);
    const auto cell = [&](int k) { return Cell{k % grid.width(), k / grid.width()}; };
    const GeneMap map({grid, moves, cell(numbers.front()), cell(numbers.back())});
    std::vector<Gene> genes;
    for (const int k : numbers) genes.push_back(static_cast<Gene>(grid.index(cell(k))));
    PlaceTable places(map.size());
    LoopFreePath path(places);
    std::vector<Gene> slot(64);
    path.open(slot);
    Inserter inserter(map, rule, repair, reach);
    Stream stream(seed);
    outcome = inserter.fill(genes, limit, Meter{Budget{}}, stream, path);
    checks = inserter.checks();
    if (outcome != Inserter::Outcome::filled) return std::nullopt;
    std::vector<int> filled;
    for (const Gene gene : path.genes()) filled.push_back(map.cell(gene).y * grid.width() + map.cell(gene).x);
    return filled;
  }
};

using Numbers = std::vector<int>;

TEST(GaInsertion, PrefersTheLowerRightAndElseWhatIsNearestToTheNextGene) {
  // Fig. 5: right of 6 only 7 is legal (11 is blocked); below 7 only 12; then 18 and 24.
  EXPECT_EQ((Insert{fig5}.fill({0, 24})), (Numbers{0, 6, 7, 12, 18, 24}));
  // Fig. 6: below 6 only 11; of 12 and 16, 12 is nearer to 24; below 17 is blocked, so 13, then 19.
  EXPECT_EQ((Insert{fig6}.fill({0, 24})), (Numbers{0, 6, 11, 12, 13, 19, 24}));
}

TEST(GaInsertion, LeavesNeighboursAloneWhereverTheyLie) {
  EXPECT_EQ((Insert{open_5x5}.fill({0, 1, 6, 5, 11, 12, 8, 9, 14, 18, 24})),
            (Numbers{0, 1, 6, 5, 11, 12, 8, 9, 14, 18, 24}));
}

TEST(GaInsertion, FaithfulDropsGenesUpOrToTheLeftAndNeverPassesTheNextOne) {
  EXPECT_EQ((Insert{open_5x5}.fill({0, 12, 3, 24})), (Numbers{0, 6, 12, 18, 24}));
  EXPECT_EQ((Insert{open_5x5}.fill({0, 12, 10, 24})), (Numbers{0, 6, 12, 18, 24}));
  EXPECT_EQ((Insert{open_5x5}.fill({0, 3, 24})), (Numbers{0, 1, 2, 3, 9, 14, 19, 24}));
  EXPECT_EQ((Insert{open_5x5}.fill({0, 15, 24})), (Numbers{0, 5, 10, 15, 21, 22, 23, 24}));
}

TEST(GaInsertion, BlindPassesAGeneInItsRowAndDropsItThen) {
  EXPECT_EQ((Insert{open_5x5, Insertion::blind}.fill({0, 3, 24})), (Numbers{0, 6, 12, 18, 24}));
}

TEST(GaInsertion, FaithfulDropsAGeneBehindAWallButDeletesAnIndividualThatCannotMove) {
  // 1 is blocked, so 2 cannot be reached to the right; the lower half is open.
  EXPECT_EQ((Insert{{".#...", ".....", "....."}}.fill({0, 2, 14})), (Numbers{0, 5, 11, 12, 13, 14}));
  const Insert stuck{{".#.", "#..", "..."}};
  EXPECT_EQ(stuck.fill({0, 8}), std::nullopt);
  EXPECT_EQ(stuck.outcome, Inserter::Outcome::deleted);
}

TEST(GaInsertion, TiesAreBrokenAtRandom) {
  std::set<Numbers> seen;
  for (std::uint64_t seed = 0; seed < 64; ++seed) {
    Insert insert{{"...", ".#.", "..."}};
    insert.seed = seed;
    seen.insert(insert.fill({0, 8}).value());
  }
  EXPECT_EQ(seen, (std::set<Numbers>{{0, 1, 2, 5, 8}, {0, 3, 6, 7, 8}}));
}

TEST(GaInsertion, GeneralTurnsTheThreeDirectionsTowardsTheNextGene) {
  constexpr unsigned e = 1, se = 2, s = 4, sw = 8, w = 16, nw = 32, n = 64, ne = 128;
  const auto fan = [](Cell to) { return fan_towards(Insertion::general, {5, 5}, to); };
  EXPECT_EQ(fan({9, 6}), (Fan{e | se | s, 1}));
  EXPECT_EQ(fan({9, 5}), (Fan{ne | e | se, 0}));
  EXPECT_EQ(fan({1, 1}), (Fan{w | nw | n, 5}));
  EXPECT_EQ(fan({5, 2}), (Fan{nw | n | ne, 6}));
  EXPECT_EQ(fan({6, 2}), (Fan{n | ne | e, 7}));
  EXPECT_EQ(fan({2, 5}), (Fan{sw | w | nw, 4}));
  EXPECT_EQ((Insert{open_5x5, Insertion::general}.fill({24, 0})), (Numbers{24, 18, 12, 6, 0}));
  EXPECT_EQ((Insert{open_5x5, Insertion::general}.fill({0, 12, 3, 24})),
            (Numbers{0, 6, 12, 8, 3, 9, 14, 19, 24}));
}

TEST(GaInsertion, WithoutRepairABlockedGapDeletesTheIndividual) {
  const Insert wall{{".....", ".#...", "....."}, Insertion::general};
  EXPECT_EQ(wall.fill({5, 9}), std::nullopt);  // strict corners: 6 blocks both diagonals too
  const Insert corners{{".....", ".#...", "....."}, Insertion::general, GapRepair::none, MoveRule::free};
  const auto around = corners.fill({5, 9});
  EXPECT_TRUE(around == (Numbers{5, 1, 7, 8, 9}) || around == (Numbers{5, 11, 7, 8, 9}));
}

TEST(GaInsertion, ADetourLeadsToTheNearestCellThatIsNearerToTheGene) {
  std::set<Numbers> seen;
  for (std::uint64_t seed = 0; seed < 64; ++seed) {
    Insert insert{{".....", ".#...", "....."}, Insertion::general, GapRepair::local_search};
    insert.seed = seed;
    seen.insert(insert.fill({5, 9}).value());
    // The corner at 6 forbids the diagonal from 1 to 7. One check at each of 5, 1, 2 and 8 (or their mirror
    // images), and two expanded cells, 5 and 0.
    EXPECT_EQ(insert.checks, 4U + 2U);
  }
  EXPECT_EQ(seen, (std::set<Numbers>{{5, 0, 1, 2, 8, 9}, {5, 10, 11, 12, 8, 9}}));
}

TEST(GaInsertion, AGeneOutOfADetoursReachIsDroppedUnlessItIsTheLast) {
  Insert cup{{".....", "..#..", "...#.", "..#..", "....."}, Insertion::general, GapRepair::local_search};
  cup.rows = {"....", ".##.", "..#.", ".##.", "...."};  // 9 in a cup that opens to the left; 11 beyond it
  EXPECT_TRUE(cup.fill({9, 11}).has_value());
  cup.reach = 2;
  EXPECT_EQ(cup.fill({9, 11}), std::nullopt);
  EXPECT_EQ(cup.fill({9, 11, 8}), (Numbers{9, 8}));
}

TEST(GaInsertion, StopsAtTheLimitOnChecks) {
  for (std::uint64_t limit = 0; limit < 5; ++limit) {
    Insert insert{fig5};
    insert.limit = limit;
    EXPECT_EQ(insert.fill({0, 24}), std::nullopt);
    EXPECT_EQ(insert.outcome, Inserter::Outcome::cut);
    EXPECT_EQ(insert.checks, limit);
  }
  Insert insert{fig5};
  insert.limit = 5;
  EXPECT_TRUE(insert.fill({0, 24}).has_value());
}

}  // namespace
}  // namespace pathrace::testing
