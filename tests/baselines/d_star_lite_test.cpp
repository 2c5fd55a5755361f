// D* Lite: against the oracle on maps that change.
#include "baselines/incremental/d_star_lite.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "core/moves.hpp"
#include "scenarios/library.hpp"
#include "tests/support/maps.hpp"
#include "tests/support/oracle.hpp"
#include "tests/support/trials.hpp"
#include "tests/support/worlds.hpp"

namespace pathrace::testing {
namespace {

using baselines::DStarLite;
using baselines::Outcome;
using baselines::TieRule;

constexpr TieRule all_ties[] = {TieRule::paper, TieRule::near_robot};

const Meter& unlimited() {
  static const Meter meter{Budget{}};
  return meter;
}

Cell any_free_cell(const OccupancyGrid& grid, Stream& stream) {
  const std::vector<Cell> cells = free_cells_of(grid);
  return cells[stream.below(cells.size())];
}

void flip(OccupancyGrid& grid, Cell cell) {
  if (grid.is_free(cell)) {
    grid.block(cell);
  } else {
    grid.clear(cell);
  }
}

void flip_some(OccupancyGrid& grid, std::uint64_t count, Stream& stream) {
  for (std::uint64_t k = 0; k < count; ++k) {
    flip(grid, {stream.between(0, grid.width() - 1), stream.between(0, grid.height() - 1)});
  }
}

// Now and then a whole column blocks or frees, so that goals are lost and found again.
void change(OccupancyGrid& grid, Stream& stream) {
  flip_some(grid, stream.below(5), stream);
  if (!stream.chance(0.25)) return;
  const int x = stream.between(0, grid.width() - 1);
  const bool blocks = stream.chance(0.5);
  for (int y = 0; y < grid.height(); ++y) {
    if (grid.is_free({x, y}) == blocks) flip(grid, {x, y});
  }
}

// The second one, or the only one.
Cell next_cell(const Path& path) {
  const Point point = path.points[std::min<std::size_t>(1, path.points.size() - 1)];
  return {static_cast<int>(point.x), static_cast<int>(point.y)};
}

// The steps are legal, and as long in all as was said.
void expect_legal(const Path& path, const OccupancyGrid& grid, MoveRule rule, LatticeLength length) {
  LatticeLength walked;
  for (std::size_t i = 1; i < path.points.size(); ++i) {
    const Cell from{static_cast<int>(path.points[i - 1].x), static_cast<int>(path.points[i - 1].y)};
    const Cell to{static_cast<int>(path.points[i].x), static_cast<int>(path.points[i].y)};
    ASSERT_TRUE(oracle_step(grid, rule, from, to)) << i;
    (from.x != to.x && from.y != to.y ? walked.diagonal : walked.straight) += 1;
  }
  ASSERT_EQ(walked, length);
}

TEST(DStarLite, FindsTheOraclesOptimumAfterEachChangeOfTheMapTheRobotAndTheGoal) {
  std::size_t lost = 0;
  std::size_t regained = 0;
  for (std::uint64_t i = 0; i < 320; ++i) {
    Stream stream = Stream(83).fork(i);
    auto [grid, robot, goal] = random_question(stream.fork(0), 9, 0.4);
    const MoveRule rule = all_rules[i % 4];
    DStarLite searches[] = {DStarLite(terrain_of(grid, rule), TieRule::paper),
                            DStarLite(terrain_of(grid, rule), TieRule::near_robot)};
    bool had_way = true;
    for (int round = 0; round < 12; ++round) {
      const auto optimum = oracle_optimum(grid, rule, robot, goal);
      lost += had_way && !optimum ? 1 : 0;
      regained += !had_way && optimum ? 1 : 0;
      had_way = optimum.has_value();
      for (DStarLite& search : searches) {
        const Outcome outcome = search.search(grid, robot, goal, unlimited());
        ASSERT_EQ(outcome, optimum ? Outcome::found : Outcome::no_way) << i << " round " << round;
        ASSERT_EQ(search.distance(), optimum) << i << " round " << round;
        if (!optimum) continue;
        const Path path = search.path();
        ASSERT_EQ(path.points.front(), centre(robot));
        ASSERT_EQ(path.points.back(), centre(goal));
        expect_legal(path, grid, rule, *optimum);
        ASSERT_FALSE(HasFatalFailure()) << i << " round " << round;
      }
      if (optimum) robot = next_cell(searches[0].path());
      change(grid, stream);
      grid.clear(robot);
      grid.clear(goal);
      if (stream.chance(0.2)) robot = any_free_cell(grid, stream);
      if (stream.chance(0.1)) goal = any_free_cell(grid, stream);
    }
  }
  EXPECT_GT(lost, 100U);  // the sequences are worth their name
  EXPECT_GT(regained, 100U);
}

TEST(DStarLite, ExpandsFewerCellsInSumThanSearchesFromScratch) {
  for (const TieRule ties : all_ties) {
    std::uint64_t repaired = 0;
    std::uint64_t afresh = 0;
    for (std::uint64_t i = 0; i < 20; ++i) {
      Stream stream = Stream(89).fork(i);
      OccupancyGrid grid = random_grid(stream.fork(0), 50, 50, 0.2);
      Cell robot{1, 1};
      const Cell goal{48, 47};
      grid.clear(robot);
      grid.clear(goal);
      DStarLite search(terrain_of(grid), ties);
      for (int round = 0; round < 40; ++round) {
        const bool found = search.search(grid, robot, goal, unlimited()) == Outcome::found;
        if (round > 0) repaired += search.expanded();
        DStarLite fresh(terrain_of(grid), ties);
        ASSERT_EQ(fresh.search(grid, robot, goal, unlimited()) == Outcome::found, found);
        ASSERT_EQ(fresh.distance(), search.distance());
        if (round > 0) afresh += fresh.expanded();
        if (found) robot = next_cell(search.path());
        flip_some(grid, 5, stream);
        grid.clear(robot);
        grid.clear(goal);
      }
    }
    EXPECT_LT(2 * repaired, afresh) << name(ties);
  }
}

TEST(DStarLite, ExpandsNothingWhileTheRobotFollowsItsPathOnAMapThatStaysAsItIs) {
  for (const TieRule ties : all_ties) {
    const Question question = random_question(Stream(97), 30, 0.3);
    DStarLite search(terrain_of(question.grid), ties);
    ASSERT_EQ(search.search(question.grid, question.start, question.goal, unlimited()), Outcome::found);
    const Path path = search.path();
    for (std::size_t left = path.points.size() - 1; left > 0; --left) {
      const Cell robot = next_cell(search.path());
      ASSERT_EQ(search.search(question.grid, robot, question.goal, unlimited()), Outcome::found);
      EXPECT_EQ(search.expanded(), 0U);
      EXPECT_FALSE(search.restarted());
    }
  }
}

// A corridor of one cell's width: the search sees x = 3..9 of it, in that order from the right.
TEST(DStarLite, ExpandsWhatAChangeTouchesAndNothingElse) {
  OccupancyGrid grid = grid_of({"..........", "##########", ".........."});
  DStarLite search(terrain_of(grid));
  ASSERT_EQ(search.search(grid, {3, 0}, {9, 0}, unlimited()), Outcome::found);
  EXPECT_EQ(search.expanded(), 6U);  // 9 to 4; the robot's own cell needs no more than its rhs
  grid.block({1, 0});
  grid.block({5, 2});
  ASSERT_EQ(search.search(grid, {3, 0}, {9, 0}, unlimited()), Outcome::found);
  EXPECT_EQ(search.expanded(), 0U);
  grid.block({6, 0});
  EXPECT_EQ(search.search(grid, {3, 0}, {9, 0}, unlimited()), Outcome::no_way);
  EXPECT_EQ(search.distance(), std::nullopt);
  grid.clear({6, 0});
  ASSERT_EQ(search.search(grid, {3, 0}, {9, 0}, unlimited()), Outcome::found);
  EXPECT_EQ(search.expanded(), 3U);  // 6, 5 and 4 again; 7 to 9 have never lost their distances
  EXPECT_EQ(search.distance(), (LatticeLength{6, 0}));
}

TEST(DStarLite, ARobotAtItsGoalIsThereWithoutAnExpansion) {
  const OccupancyGrid grid(4, 4);
  DStarLite search(terrain_of(grid));
  ASSERT_EQ(search.search(grid, {2, 1}, {2, 1}, unlimited()), Outcome::found);
  EXPECT_EQ(search.expanded(), 0U);
  EXPECT_EQ(search.path().points, (std::vector<Point>{{2, 1}}));
}

// The goal is in the middle of a corridor. The cell behind it waits in the queue with the key 1 + 6; that is
// no more than the robot's distance after its step back, 6 + k_m = 7, but the cell is farther from there: 1 +
// 7 + 1.
TEST(DStarLite, RaisesTheKeysThatWereMadeForAnEarlierPlaceOfTheRobotBeforeItExpands) {
  const OccupancyGrid grid(21, 1);
  DStarLite search(terrain_of(grid));
  ASSERT_EQ(search.search(grid, {5, 0}, {10, 0}, unlimited()), Outcome::found);
  EXPECT_EQ(search.expanded(), 5U);  // 10 to 6
  ASSERT_EQ(search.search(grid, {4, 0}, {10, 0}, unlimited()), Outcome::found);
  EXPECT_EQ(search.expanded(), 1U);  // 5
}

TEST(DStarLite, ARobotThatIsShutInCostsNothingUntilItIsFree) {
  OccupancyGrid grid = grid_of({".#......", "##......", "........"});
  DStarLite search(terrain_of(grid));
  EXPECT_EQ(search.search(grid, {0, 0}, {7, 0}, unlimited()), Outcome::no_way);
  EXPECT_EQ(search.expanded(), 0U);
  EXPECT_EQ(search.distance(), std::nullopt);
  grid.clear({1, 0});
  ASSERT_EQ(search.search(grid, {0, 0}, {7, 0}, unlimited()), Outcome::found);
  EXPECT_EQ(search.distance(), (LatticeLength{7, 0}));
}

TEST(DStarLite, StartsAnewWhenTheGoalLeavesItsCell) {
  const OccupancyGrid grid(20, 20);
  DStarLite search(terrain_of(grid));
  search.search(grid, {1, 1}, {18, 9}, unlimited());
  EXPECT_TRUE(search.restarted());
  search.search(grid, {2, 2}, {18, 9}, unlimited());
  EXPECT_FALSE(search.restarted());
  search.search(grid, {2, 2}, {18, 10}, unlimited());
  EXPECT_TRUE(search.restarted());
  EXPECT_EQ(search.distance(), (LatticeLength{8, 8}));
}

TEST(DStarLite, StopsAtTheBudgetOfChecksExactlyAndGoesOnFromThere) {
  for (const TieRule ties : all_ties) {
    const OccupancyGrid grid = random_grid(Stream(101), 40, 40, 0.2);
    const std::vector<Cell> cells = free_cells_of(grid);
    DStarLite whole(terrain_of(grid), ties);
    ASSERT_EQ(whole.search(grid, cells.front(), cells.back(), unlimited()), Outcome::found);
    Budget budget;
    budget.checks = 7;
    DStarLite search(terrain_of(grid), ties);
    std::uint64_t expanded = 0;
    while (search.search(grid, cells.front(), cells.back(), Meter(budget)) == Outcome::cut) {
      ASSERT_EQ(search.expanded(), 7U);
      expanded += search.expanded();
    }
    EXPECT_EQ(expanded + search.expanded(), whole.expanded());
    EXPECT_EQ(search.path(), whole.path());
  }
}

TEST(ChangingMap, KnowsTheLegalStepsAndWhoseHaveChanged) {
  for (std::uint64_t i = 0; i < 100; ++i) {
    Stream stream = Stream(103).fork(i);
    OccupancyGrid grid = random_grid(stream.fork(0), 7, 6, 0.3);
    const MoveRule rule = all_rules[i % 4];
    baselines::ChangingMap map(terrain_of(grid, rule));
    MoveTable before(grid, rule);
    for (int round = 0; round < 10; ++round) {
      change(grid, stream);
      const MoveTable now(grid, rule);
      std::vector<std::uint32_t> changed = map.look(grid);
      std::sort(changed.begin(), changed.end());
      std::vector<std::uint32_t> expected;
      for (std::size_t index = 0; index < now.size(); ++index) {
        ASSERT_EQ(map.steps(index), now[index]) << i << " round " << round;
        if (now[index] != before[index]) expected.push_back(static_cast<std::uint32_t>(index));
      }
      ASSERT_EQ(changed, expected) << i << " round " << round;
      before = now;
    }
  }
}

TEST(KeyedHeap, KeepsItsLeastEntryOnTopWhateverChanges) {
  using Heap = baselines::KeyedHeap;
  Heap heap(40);
  std::set<Heap::Entry> expected;
  Stream stream(107);
  const auto known = [&](std::uint32_t cell) {
    return std::find_if(expected.begin(), expected.end(),
                        [&](const auto& entry) { return entry.cell == cell; });
  };
  for (int round = 0; round < 5000; ++round) {
    const auto cell = static_cast<std::uint32_t>(stream.below(40));
    if (const auto at = known(cell); at != expected.end()) expected.erase(at);
    if (stream.chance(0.6)) {
      const Heap::Entry entry{{stream.below(8), stream.below(3)}, cell};
      heap.put(cell, entry.key);
      expected.insert(entry);
    } else {
      heap.remove(cell);
    }
    ASSERT_EQ(heap.empty(), expected.empty());
    if (!heap.empty()) {
      ASSERT_EQ(heap.top(), *expected.begin()) << round;
    }
  }
  heap.clear();
  EXPECT_TRUE(heap.empty());
  heap.put(3, {1, 1});
  EXPECT_EQ(heap.top().cell, 3U);
}

}  // namespace
}  // namespace pathrace::testing
