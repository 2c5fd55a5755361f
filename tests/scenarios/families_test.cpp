// What each family promises of its maps, beyond the contract.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <set>

#include "scenarios/components.hpp"
#include "scenarios/library.hpp"
#include "tests/support/maps.hpp"
#include "tests/support/oracle.hpp"

namespace pathrace::scenarios {
namespace {

using pathrace::testing::oracle_optimum;

std::int64_t blocked_cells(const OccupancyGrid& grid) {
  return std::int64_t{grid.width()} * grid.height() - grid.free_cells();
}

bool blocked(const OccupancyGrid& grid, int x, int y) {
  return grid.contains({x, y}) && !grid.is_free({x, y});
}

TEST(Traps, AreLongerThanOverOpenGround) {
  const Library library;
  for (const char* kind : {"trap-l", "trap-u", "trap-hook", "trap-nested-l", "trap-baffle", "trap-comb",
                           "trap-spiral", "trap-bug"}) {
    int longer = 0;
    for (int seed = 1; seed <= 30; ++seed) {
      const Scenario scenario = library.load(fmt::format("{}/20/{}", kind, seed));
      const int dx = std::abs(scenario.start.x - scenario.goal.x);
      const int dy = std::abs(scenario.start.y - scenario.goal.y);
      const LatticeLength open{std::abs(dx - dy), std::min(dx, dy)};
      longer += *scenario.optimum.length > open ? 1 : 0;
    }
    EXPECT_GE(longer, 27) << kind;  // a comb near the edge, or a shallow L, may leave the shortest way free
  }
}

TEST(Traps, FaceWhereTheIdSays) {
  const Library library;
  for (int seed = 1; seed <= 10; ++seed) {
    const auto load = [&](const char* kind, const char* facing) {
      return library.load(fmt::format("{}/20,facing={}/{}", kind, facing, seed));
    };
    EXPECT_EQ(load("trap-u", "east").goal.x, 19);
    EXPECT_EQ(load("trap-u", "south").goal.y, 19);
    EXPECT_EQ(load("trap-u", "west").goal.x, 0);
    EXPECT_EQ(load("trap-u", "north").goal.y, 0);
    EXPECT_EQ(load("trap-l", "east").goal, (Cell{19, 19}));
    EXPECT_EQ(load("trap-l", "south").goal, (Cell{0, 19}));
    EXPECT_EQ(load("trap-l", "west").goal, (Cell{0, 0}));
    EXPECT_EQ(load("trap-l", "north").goal, (Cell{19, 0}));
  }
}

TEST(Traps, TurnToEverySideByTheirSeed) {
  const Library library;
  std::set<Cell> goals;
  for (int seed = 1; seed <= 30; ++seed) goals.insert(library.load(fmt::format("trap-l/20/{}", seed)).goal);
  EXPECT_EQ(goals.size(), 4U);
}

// An L with arms of 40 % of 20 cells: a corner and eight cells either way.
TEST(Traps, HaveTheDepthThatTheIdSays) {
  const Library library;
  for (int seed = 1; seed <= 10; ++seed) {
    EXPECT_EQ(blocked_cells(library.load(fmt::format("trap-l/20,depth=40/{}", seed)).grid()), 17);
  }
}

// Three walls across 20 rows, each with a mouth of 10 % = 2 cells.
TEST(Traps, NestAsOftenAsTheIdSays) {
  const Library library;
  for (int seed = 1; seed <= 10; ++seed) {
    EXPECT_EQ(blocked_cells(library.load(fmt::format("trap-baffle/20,mouth=10,nesting=3/{}", seed)).grid()),
              3 * 18);
  }
}

TEST(TrapTunnel, HasNoOtherWayThrough) {
  const Library library;
  for (int seed = 1; seed <= 20; ++seed) {
    const Scenario scenario = library.load(fmt::format("trap-tunnel/20,mouth=5/{}", seed));
    int narrow = 0;  // lines across the map, along or across, with just one free cell
    for (int i = 0; i < 20; ++i) {
      int row = 0;
      int column = 0;
      for (int j = 0; j < 20; ++j) {
        row += scenario.grid().is_free({j, i}) ? 1 : 0;
        column += scenario.grid().is_free({i, j}) ? 1 : 0;
      }
      narrow += row == 1 || column == 1 ? 1 : 0;
    }
    EXPECT_GE(narrow, 2) << seed;
  }
}

TEST(Dense, BlocksExactlyItsShareOfTheCells) {
  const Library library;
  for (const int n : {5, 10, 20, 33}) {
    for (const int percent : {0, 1, 10, 20, 30, 40}) {
      const Scenario scenario = library.load(fmt::format("dense/{}-{}/7", n, percent));
      EXPECT_EQ(blocked_cells(scenario.grid()), (n * n * percent + 50) / 100) << n << ' ' << percent;
      EXPECT_EQ(scenario.start, (Cell{0, 0}));
      EXPECT_EQ(scenario.goal, (Cell{n - 1, n - 1}));
    }
  }
}

// Binomial: 10,000 cells at 35 %, standard deviation 47.7.
TEST(Random, BlocksItsShareOfTheCellsOnAverage) {
  const Scenario scenario = Library().load("random/100-35/1");
  EXPECT_NEAR(static_cast<double>(blocked_cells(scenario.grid())), 3500, 4 * 47.7);
}

TEST(Scatter, HasSingleCellsOnlyAndTellsTheMoveRulesApart) {
  const Library library;
  int apart = 0;
  for (int seed = 1; seed <= 10; ++seed) {
    const Scenario scenario = library.load(fmt::format("scatter/20-25/{}", seed));
    const OccupancyGrid& grid = scenario.grid();
    for (int y = 0; y < 20; ++y) {
      for (int x = 0; x < 20; ++x) {
        if (!blocked(grid, x, y)) continue;
        EXPECT_FALSE(blocked(grid, x + 1, y) || blocked(grid, x, y + 1)) << seed;
      }
    }
    const auto free = oracle_optimum(grid, MoveRule::free, scenario.start, scenario.goal);
    apart += *free < *scenario.optimum.length ? 1 : 0;
  }
  EXPECT_EQ(apart, 10);
}

// A maze without loops is a tree: one free cell more than pairs of neighbours, for corridors of one cell.
TEST(Maze, HasExactlyOneWayBetweenAnyTwoCells) {
  const Library library;
  for (int seed = 1; seed <= 10; ++seed) {
    const Scenario scenario = library.load(fmt::format("maze/21-1/{}", seed));
    std::int64_t edges = 0;
    for (int y = 0; y < 21; ++y) {
      for (int x = 0; x < 21; ++x) {
        if (!scenario.grid().is_free({x, y})) continue;
        edges += scenario.grid().is_free({x + 1, y}) ? 1 : 0;
        edges += scenario.grid().is_free({x, y + 1}) ? 1 : 0;
      }
    }
    EXPECT_EQ(scenario.grid().free_cells(), edges + 1) << seed;
    EXPECT_EQ(largest_region(scenario.grid()).size(), static_cast<std::size_t>(scenario.grid().free_cells()));
  }
}

TEST(Maze, WithAllLoopsIsAGridOfCorridors) {
  const Scenario scenario = Library().load("maze/21-1,loops=100/1");
  EXPECT_EQ(blocked_cells(scenario.grid()), 10 * 10);  // the posts alone
}

TEST(Rooms, AreAllJoined) {
  const Library library;
  for (int seed = 1; seed <= 10; ++seed) {
    const Scenario scenario = library.load(fmt::format("rooms/40-5,doors=0/{}", seed));
    EXPECT_EQ(largest_region(scenario.grid()).size(), static_cast<std::size_t>(scenario.grid().free_cells()));
    // 7 x 7 rooms, 48 doors of one cell; 6 walls each way of 40 cells, 36 crossings counted twice.
    EXPECT_EQ(blocked_cells(scenario.grid()), 2 * 6 * 40 - 36 - 48);
  }
}

// After many rounds nothing moves: a cell is blocked where five of the nine cells around and including it
// are, those outside the map among them.
TEST(Caves, EndAsFixedPointsOfTheAutomaton) {
  const Library library;
  for (int seed = 1; seed <= 5; ++seed) {
    const Scenario scenario = library.load(fmt::format("caves/20-42,rounds=20/{}", seed));
    for (int y = 0; y < 20; ++y) {
      for (int x = 0; x < 20; ++x) {
        int around = 0;
        for (int dy = -1; dy <= 1; ++dy) {
          for (int dx = -1; dx <= 1; ++dx) around += scenario.grid().is_free({x + dx, y + dy}) ? 0 : 1;
        }
        EXPECT_EQ(blocked(scenario.grid(), x, y), around >= 5) << seed << ": " << x << ',' << y;
      }
    }
  }
}

// Without gaps and pallets: aisles of two around racks of two by five.
TEST(Warehouse, HasRacksInRowsAndFreeAislesBetweenThem) {
  const Scenario scenario = Library().load("warehouse/23-2,missing=0,pallets=0/1");
  for (int y = 0; y < 23; ++y) {
    for (int x = 0; x < 23; ++x) {
      const bool aisle = x % 7 < 2 || y % 4 < 2 || x == 22 || y == 22;
      EXPECT_EQ(blocked(scenario.grid(), x, y), !aisle) << x << ',' << y;
    }
  }
}

TEST(City, HasStreetsAcrossTheWholeMap) {
  const Library library;
  for (int seed = 1; seed <= 10; ++seed) {
    const Scenario scenario = library.load(fmt::format("city/40-6/{}", seed));
    int streets = 0;
    for (int i = 0; i < 40; ++i) {
      bool open = true;
      for (int j = 0; j < 40; ++j) open = open && scenario.grid().is_free({i, j});
      streets += open ? 1 : 0;
    }
    EXPECT_GE(streets, 5) << seed;  // 40 cells in blocks of at most nine and streets of one
  }
}

TEST(Asr, OptimaAreThoseOfThePaper) {
  const Library library;
  EXPECT_EQ(library.load("asr/fig2").optimum.length, (LatticeLength{4, 2}));  // 6.8284
  EXPECT_EQ(library.load("asr/fig5").optimum.length,
            (LatticeLength{2, 3}));  // 6.2426, the paper's 312.1 cm / 50
  EXPECT_EQ(library.load("asr/fig6").optimum.length, (LatticeLength{4, 2}));  // 6.8284
}

TEST(Curated, MapsHaveTheStatedEndsAndOptima) {
  const Library library;
  for (const pathrace::testing::ReferenceMap& map : pathrace::testing::reference_maps()) {
    const Scenario scenario = library.load(map.name);
    EXPECT_EQ(scenario.start, map.start) << map.name;
    EXPECT_EQ(scenario.goal, map.goal) << map.name;
    EXPECT_EQ(scenario.optimum.length, map.strict) << map.name;
  }
}

}  // namespace
}  // namespace pathrace::scenarios
