// A trail on a small map, and walks over it.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "algorithms/aco/trail.hpp"
#include "core/moves.hpp"
#include "core/stream.hpp"
#include "tests/support/maps.hpp"

namespace pathrace::algorithms {

inline constexpr auto equal = [](std::size_t, int) { return 1.0; };
inline const std::vector<std::string> open_ground = {"...", "...", "..."};

struct Field {
  Field(const std::vector<std::string>& rows, MoveRule rule, double alpha, double beta,
        const Trail::Heuristic& eta, double initial = 1)
      : grid(testing::grid_of(rows)), moves(grid, rule), trail(moves, initial, alpha, beta, eta) {}

  std::size_t at(int x, int y) const { return grid.index({x, y}); }

  OccupancyGrid grid;
  MoveTable moves;
  Trail trail;
};

// Where ants read.
inline void expect_same_strengths(const Field& field, const Field& expected) {
  for (std::size_t i = 0; i < expected.moves.size(); ++i) {
    if (expected.moves[i] == 0) continue;
    ASSERT_EQ(field.trail.rows()[i].strength, expected.trail.rows()[i].strength) << i;
  }
}

// So many steps in random directions, over the whole of an open map.
inline std::vector<std::uint8_t> random_walk(const MoveTable& moves, std::size_t index, Stream& stream,
                                             std::size_t steps = 60) {
  std::vector<std::uint8_t> directions;
  while (directions.size() < steps) {
    const int d = stream.between(0, 7);
    if ((moves[index] >> d & 1) == 0) continue;
    directions.push_back(static_cast<std::uint8_t>(d));
    index = moves.step(index, d);
  }
  return directions;
}

}  // namespace pathrace::algorithms
