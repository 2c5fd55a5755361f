// Ground to walk on, and what ants bring home from it.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "algorithms/aco/walker.hpp"
#include "tests/support/maps.hpp"

namespace pathrace::algorithms {

inline constexpr std::uint64_t no_limit = 1'000'000;

struct WalkField {
  WalkField(
      OccupancyGrid map, MoveRule rule, Cell start, Cell goal,
      const Trail::Heuristic& eta = [](std::size_t, int) { return 1.0; })
      : grid(std::move(map)), nest({grid, rule, start, goal}), trail(nest.moves(), 1, 1, 1, eta) {}

  Ground ground(DeadEnd dead_end) const {
    Ground ground{nest, trail};
    ground.dead_end = dead_end;
    ground.max_steps = no_limit;
    ground.keep_the_dead = true;
    ground.keep_popped = true;
    return ground;
  }

  std::vector<Walk> walk(DeadEnd dead_end, std::size_t ants, std::uint64_t seed,
                         std::uint64_t limit = no_limit) const {
    return walk_on(ground(dead_end), ants, seed, limit, 4);
  }

  // Then steps back are taken by the same instructions as others, unless they are listed.
  void let_every_step_weigh() {
    trail.limit(0x1p-40, Trail::no_limit);
    EXPECT_TRUE(trail.every_step_weighs());
  }

  static std::vector<Walk> walk_on(const Ground& ground, std::size_t ants, std::uint64_t seed,
                                   std::uint64_t limit, std::size_t lanes) {
    std::vector<Walk> walks(ants);
    AntQueue queue(0, ants);
    const Stream stream(seed);
    const Meter meter({});
    Walker(ground, lanes).run(queue, {stream, limit, meter, walks});
    return walks;
  }

  void expect_simple_and_legal(const Walk& walk) const {
    const std::vector<std::uint32_t> cells = cells_of(nest, walk);
    EXPECT_EQ(std::set<std::uint32_t>(cells.begin(), cells.end()).size(), cells.size());
    for_each_step(nest, walk, [&](std::size_t index, int d) { EXPECT_NE(nest.moves()[index] >> d & 1, 0); });
    EXPECT_EQ(static_cast<std::size_t>(walk.length.straight + walk.length.diagonal), walk.directions.size());
    if (walk.arrived) {
      EXPECT_EQ(cells.back(), nest.goal());
    }
  }

  OccupancyGrid grid;
  Nest nest;
  Trail trail;
};

}  // namespace pathrace::algorithms
