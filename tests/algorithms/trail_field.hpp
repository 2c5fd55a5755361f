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

// A walk over the whole of an open map, of steps in random directions.
inline std::vector<std::uint8_t> random_walk(const Field& field, std::size_t index, Stream& stream) {
  std::vector<std::uint8_t> directions;
  while (directions.size() < 60) {
    const int d = stream.between(0, 7);
    if ((field.moves[index] >> d & 1) == 0) continue;
    directions.push_back(static_cast<std::uint8_t>(d));
    index = field.moves.step(index, d);
  }
  return directions;
}

}  // namespace pathrace::algorithms
