// Dead cells: what marking them does to the best way that is left.
#include "algorithms/aco/dead_cells.hpp"

#include <gtest/gtest.h>

#include <map>
#include <optional>
#include <set>

#include "core/lattice_length.hpp"
#include "core/stream.hpp"
#include "scenarios/movingai/map_file.hpp"
#include "tests/support/data_folder.hpp"
#include "tests/support/maps.hpp"
#include "tests/support/oracle.hpp"

namespace pathrace::algorithms {
namespace {

using testing::oracle_step;

// Bellman-Ford over the living cells; the corner rule sees `walls`.
std::optional<LatticeLength> best_left(const OccupancyGrid& walls, MoveRule rule, const LiveMoves& moves,
                                       Cell start, Cell goal) {
  std::map<Cell, LatticeLength> best{{start, {0, 0}}};
  for (bool changed = true; changed;) {
    changed = false;
    const std::map<Cell, LatticeLength> reached = best;
    for (const auto& [from, length] : reached) {
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
          const Cell to{from.x + dx, from.y + dy};
          if (!oracle_step(walls, rule, from, to) || !moves.alive(walls.index(to))) continue;
          const LatticeLength there =
              length + (dx == 0 || dy == 0 ? LatticeLength{1, 0} : LatticeLength{0, 1});
          const auto known = best.find(to);
          if (known != best.end() && !(there < known->second)) continue;
          best[to] = there;
          changed = true;
        }
      }
    }
  }
  const auto found = best.find(goal);
  if (found == best.end()) return std::nullopt;
  return found->second;
}

// An ant without pheromone or heuristic that steps back along its path when it is stuck. Returns the cells it
// stepped back from.
std::vector<std::size_t> wander(const LiveMoves& moves, std::size_t start, std::size_t goal, Stream stream) {
  std::set<std::size_t> visited{start};
  std::vector<std::size_t> path{start};
  std::vector<std::size_t> left;
  while (!path.empty() && path.back() != goal) {
    std::vector<std::size_t> fresh;
    for (int d = 0; d < direction_count; ++d) {
      if ((moves[path.back()] >> d & 1) == 0) continue;
      const std::size_t next = moves.step(path.back(), d);
      if (visited.count(next) == 0) fresh.push_back(next);
    }
    if (fresh.empty()) {
      left.push_back(path.back());
      path.pop_back();
    } else {
      path.push_back(fresh[stream.below(fresh.size())]);
      visited.insert(path.back());
    }
  }
  return left;
}

struct Field {
  Field(const OccupancyGrid& map, MoveRule map_rule, Cell from, Cell to)
      : grid(map), rule(map_rule), start(from), goal(to), moves(map, map_rule) {}

  void send_ants(DeadCells& dead, int ants, const Stream& stream) {
    for (int ant = 0; ant < ants; ++ant) {
      const Stream own = stream.fork(static_cast<std::uint64_t>(ant));
      for (const std::size_t cell : wander(moves, grid.index(start), grid.index(goal), own)) {
        dead.stepped_back_from(cell);
      }
    }
  }
  std::optional<LatticeLength> best() const { return best_left(grid, rule, moves, start, goal); }

  OccupancyGrid grid;
  MoveRule rule;
  Cell start;
  Cell goal;
  LiveMoves moves;
};

TEST(LiveMoves, WithoutLossesAreTheMoveTable) {
  for (const MoveRule rule : testing::all_rules) {
    const OccupancyGrid grid = testing::random_grid(Stream(97), 12, 9, 0.3);
    const MoveTable table(grid, rule);
    const LiveMoves moves(grid, rule);
    for (std::size_t i = 0; i < table.size(); ++i) {
      EXPECT_EQ(moves[i], table[i]);
      EXPECT_EQ(moves.alive(i), !grid.blocked_at(i));
    }
  }
}

TEST(LiveMoves, AWalledCellIsAnObstacleOfTheMapUnderEveryRule) {
  for (const MoveRule rule : testing::all_rules) {
    OccupancyGrid grid = testing::random_grid(Stream(101), 12, 9, 0.2);
    LiveMoves moves(grid, rule);
    Stream stream(103);
    for (int i = 0; i < 40; ++i) {
      const std::vector<Cell> free = testing::free_cells_of(grid);
      const Cell cell = free[stream.below(free.size())];
      grid.block(cell);
      moves.wall(grid.index(cell));
      const MoveTable table(grid, rule);
      for (std::size_t k = 0; k < table.size(); ++k) ASSERT_EQ(moves[k], table[k]) << name(rule) << ' ' << i;
    }
  }
}

TEST(LiveMoves, UnwallRestoresEveryStep) {
  const OccupancyGrid grid = testing::random_grid(Stream(107), 12, 9, 0.2);
  for (const MoveRule rule : testing::all_rules) {
    const MoveTable table(grid, rule);
    LiveMoves moves(grid, rule);
    for (const Cell cell : testing::free_cells_of(grid)) {
      moves.wall(grid.index(cell));
      moves.unwall(grid.index(cell));
      ASSERT_TRUE(moves.alive(grid.index(cell)));
    }
    for (std::size_t k = 0; k < table.size(); ++k) ASSERT_EQ(moves[k], table[k]);
    OccupancyGrid one_more = grid;  // what was undone is no obstacle of the corner rule either
    one_more.block(testing::free_cells_of(grid)[20]);
    moves.wall(grid.index(testing::free_cells_of(grid)[20]));
    const MoveTable expected(one_more, rule);
    for (std::size_t k = 0; k < table.size(); ++k) ASSERT_EQ(moves[k], expected[k]) << name(rule);
  }
}

TEST(LiveMoves, ADeadCellDoesNotCloseTheDiagonalsBesideIt) {
  const OccupancyGrid grid = testing::grid_of({"...", "...", "..."});
  LiveMoves moves(grid, MoveRule::strict);
  moves.lose(grid.index({1, 1}));
  EXPECT_NE(moves[grid.index({1, 0})] >> 1 & 1, 0);  // south-east to (2,1), past the dead cell
  EXPECT_EQ(moves[grid.index({1, 0})] >> 2 & 1, 0);  // south into it
  EXPECT_EQ(moves[grid.index({1, 1})], 0);
}

TEST(Dominated, HoldsForDeadEndsAndConvexCornersButNotOnTheOnlyWay) {
  const OccupancyGrid grid = testing::grid_of({"...#", "..##", "#..."});
  const LiveMoves moves(grid, MoveRule::free);
  EXPECT_TRUE(dominated(moves, grid.index({0, 0})));   // E, SE, S are neighbours of each other
  EXPECT_TRUE(dominated(moves, grid.index({3, 2})));   // one way in
  EXPECT_FALSE(dominated(moves, grid.index({2, 2})));  // between (1,2) and (3,2)
  const LiveMoves straight(grid, MoveRule::four);
  EXPECT_TRUE(dominated(straight, grid.index({0, 0})));   // from E to S over (1,1) is as short
  EXPECT_FALSE(dominated(straight, grid.index({2, 2})));  // between (1,2) and (3,2)
}

TEST(Dominated, AWayBesideMayBendOnceButBeNoLonger) {
  const OccupancyGrid row = testing::grid_of({"....", "....", "...."});
  LiveMoves moves(row, MoveRule::strict);
  EXPECT_FALSE(dominated(moves, row.index({1, 0})));  // W to E is 2 through it, 2 sqrt 2 over (1,1)
  moves.lose(row.index({0, 0}));
  EXPECT_TRUE(dominated(moves, row.index({1, 0})));  // SW to E is 1 + sqrt 2 either way
}

TEST(DeadCells, DominatedMarksNeverChangeTheOptimumHoweverManyThereAre) {
  for (const MoveRule rule : {MoveRule::strict, MoveRule::free}) {
    std::size_t marked = 0;
    for (std::uint64_t i = 0; i < 1000; ++i) {
      const Stream stream = Stream(109).fork(i);
      const testing::Question question = testing::random_question(stream, 9, 0.45);
      Field field(question.grid, rule, question.start, question.goal);
      DeadCells dead(field.moves, DeadTable::global_dominated, DeadCells::Layer::dead,
                     field.grid.index(field.start), field.grid.index(field.goal));
      std::vector<Cell> cells = testing::free_cells_of(field.grid);
      for (std::uint64_t round = 0; round < 12; ++round) {  // fills pockets to their mouths
        Stream order = stream.fork(round);
        order.shuffle(cells);
        for (const Cell cell : cells) dead.stepped_back_from(field.grid.index(cell));
      }
      marked += dead.marked();
      ASSERT_EQ(field.best(), testing::oracle_optimum(field.grid, rule, field.start, field.goal))
          << name(rule) << ' ' << i;
    }
    EXPECT_GT(marked, 5000U) << name(rule);
  }
}

TEST(DeadCells, DominatedMarksFillAWidePocketOnceAllOfItWasSteppedBackFrom) {
  // A room three cells wide and three deep, open to the north.
  const OccupancyGrid grid =
      testing::grid_of({".......", ".......", "##...##", "##...##", "##...##", "#######"});
  Field field(grid, MoveRule::strict, {0, 0}, {6, 0});
  DeadCells dead(field.moves, DeadTable::global_dominated, DeadCells::Layer::dead, grid.index({0, 0}),
                 grid.index({6, 0}));
  for (int y = 2; y <= 4; ++y) {  // from the mouth inwards: the last cells let the first go
    for (int x = 2; x <= 4; ++x) dead.stepped_back_from(grid.index({x, y}));
  }
  EXPECT_EQ(dead.marked(), 9U);
}

TEST(DeadCells, ACellThatNobodySteppedBackFromIsNotLostWithItsNeighbours) {
  const OccupancyGrid grid = testing::grid_of({"......", "####.."});
  Field field(grid, MoveRule::strict, {5, 0}, {5, 1});
  DeadCells dead(field.moves, DeadTable::global_dominated, DeadCells::Layer::dead, grid.index({5, 0}),
                 grid.index({5, 1}));
  EXPECT_TRUE(dead.stepped_back_from(grid.index({1, 0})).empty());  // the way to (0,0)
  const std::vector<std::size_t> lost = {grid.index({0, 0}), grid.index({1, 0})};
  EXPECT_EQ(dead.stepped_back_from(grid.index({0, 0})), lost);
  EXPECT_TRUE(field.moves.alive(grid.index({2, 0})));
}

TEST(DeadCells, TheOnlyWayIsNeverMarked) {
  const OccupancyGrid grid = testing::grid_of({".......", ".####.#", "......#", "#######"});
  Field field(grid, MoveRule::strict, {0, 0}, {6, 0});
  DeadCells dead(field.moves, DeadTable::global_dominated, DeadCells::Layer::dead, grid.index({0, 0}),
                 grid.index({6, 0}));
  EXPECT_TRUE(dead.stepped_back_from(grid.index({3, 2})).empty());  // still the way between (2,2) and (4,2)
  EXPECT_TRUE(dead.stepped_back_from(grid.index({0, 0})).empty());  // the start
}

TEST(DeadCells, NoTableAndAnAntsOwnMarkNothing) {
  const OccupancyGrid grid = testing::grid_of({"..#", "..#", "..."});
  for (const DeadTable table : {DeadTable::none, DeadTable::per_ant}) {
    Field field(grid, MoveRule::strict, {0, 0}, {2, 2});
    DeadCells dead(field.moves, table, DeadCells::Layer::dead, grid.index({0, 0}), grid.index({2, 2}));
    for (const Cell cell : testing::free_cells_of(grid)) {
      EXPECT_TRUE(dead.stepped_back_from(grid.index(cell)).empty());
    }
  }
}

const testing::ReferenceMap& u_trap() {
  for (const testing::ReferenceMap& map : testing::reference_maps()) {
    if (map.name == "curated/trap-u-east-20") return map;
  }
  throw std::logic_error("curated/trap-u-east-20 is gone");
}

// In how many of ten colonies the best way is lost, by table.
int losses(const OccupancyGrid& grid, MoveRule rule, Cell start, Cell goal, LatticeLength optimum,
           DeadTable table, DeadCells::Layer layer) {
  int lost = 0;
  for (std::uint64_t run = 0; run < 10; ++run) {
    Field field(grid, rule, start, goal);
    DeadCells dead(field.moves, table, layer, grid.index(start), grid.index(goal));
    field.send_ants(dead, 60, Stream(113).fork(run));
    lost += field.best() == std::optional(optimum) ? 0 : 1;
  }
  return lost;
}

TEST(DeadCells, LiteralMarksLoseTheBestWayOutOfAUTrapAndDominatedOnesDoNot) {
  const testing::ReferenceMap& map = u_trap();
  const OccupancyGrid grid = testing::grid_of(map.rows);
  for (const MoveRule rule : {MoveRule::strict, MoveRule::free}) {
    const auto lost = [&](DeadTable table) {
      return losses(grid, rule, map.start, map.goal, map.optimum(rule), table, DeadCells::Layer::dead);
    };
    EXPECT_GE(lost(DeadTable::global_literal), 9) << name(rule);
    EXPECT_EQ(lost(DeadTable::global_dominated), 0) << name(rule);
  }
}

TEST(DeadCells, LiteralMarksLoseTheBestWayOnTheClassicMapAndDominatedOnesDoNot) {
  const auto data = testing::data_folder();
  if (!data) GTEST_SKIP() << testing::without_data;
  const auto grid = scenarios::MapFile::read(*data / "aco-grids" / "aco_20x20_xuedidi_4fcd69.map").ground();
  // Corner to corner: 34.3848 = 20 + ... under free and 37.8995 = 28 + 7 sqrt 2 under strict
  // (SMALL_OPTIMA.csv).
  const auto optimum = testing::oracle_optimum(*grid, MoveRule::free, {0, 0}, {19, 19});
  ASSERT_TRUE(optimum.has_value());
  EXPECT_NEAR(optimum->value(), 34.38477631, 1e-8);
  const auto lost = [&](DeadTable table) {
    return losses(*grid, MoveRule::free, {0, 0}, {19, 19}, *optimum, table, DeadCells::Layer::dead);
  };
  EXPECT_GE(lost(DeadTable::global_literal), 9);
  EXPECT_EQ(lost(DeadTable::global_dominated), 0);
}

TEST(DeadCells, AsObstaclesLiteralMarksAreRefusedBeforeTheyCutTheGoalOff) {
  const testing::ReferenceMap& map = u_trap();
  const OccupancyGrid grid = testing::grid_of(map.rows);
  for (const MoveRule rule : testing::all_rules) {
    Field field(grid, rule, map.start, map.goal);
    DeadCells dead(field.moves, DeadTable::global_literal, DeadCells::Layer::obstacle, grid.index(map.start),
                   grid.index(map.goal));
    field.send_ants(dead, 100, Stream(127));
    OccupancyGrid walls = grid;
    for (const Cell cell : testing::free_cells_of(grid)) {
      if (!field.moves.alive(grid.index(cell))) walls.block(cell);
    }
    EXPECT_GT(dead.marked(), 0U);
    EXPECT_TRUE(testing::oracle_reachable(walls, rule, map.start, map.goal)) << name(rule);
  }
}

}  // namespace
}  // namespace pathrace::algorithms
