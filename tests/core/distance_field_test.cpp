// Distances to all cells against the oracle's distance to each.
#include "core/reference/distance_field.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "tests/support/maps.hpp"
#include "tests/support/oracle.hpp"

namespace pathrace {
namespace {

using reference::DistanceField;
using testing::all_rules;

TEST(DistanceField, GivesTheOraclesOptimumForEveryCell) {
  for (std::uint64_t i = 0; i < 40; ++i) {
    const testing::Question asked = testing::random_question(Stream(31).fork(i), 9, 0.6);
    for (const MoveRule rule : all_rules) {
      const Terrain terrain = testing::terrain_of(asked.grid, rule);
      const DistanceField field(terrain, asked.start);
      for (const Cell cell : testing::free_cells_of(asked.grid)) {
        ASSERT_EQ(field.length(cell), testing::oracle_optimum(asked.grid, rule, asked.start, cell))
            << "map " << i << " under " << name(rule) << " to " << cell.x << ',' << cell.y;
      }
    }
  }
}

TEST(DistanceField, ListsEachCellOnceAndItsPredecessorsBeforeIt) {
  for (std::uint64_t i = 0; i < 40; ++i) {
    const testing::Question asked = testing::random_question(Stream(32).fork(i), 12, 0.5);
    const Terrain terrain = testing::terrain_of(asked.grid);
    const DistanceField field(terrain, asked.start);
    std::vector<int> place(asked.grid.padded_size(), -1);
    for (std::size_t k = 0; k < field.order().size(); ++k) {
      const std::size_t cell = field.order()[k];
      EXPECT_EQ(place[cell], -1);
      place[cell] = static_cast<int>(k);
      field.for_each_step(cell, [&](std::size_t next, bool diagonal) {
        const LatticeLength step = diagonal ? LatticeLength{0, 1} : LatticeLength{1, 0};
        const bool precedes = *field.length_at(next) + step == *field.length_at(cell);
        EXPECT_TRUE(!precedes || (place[next] >= 0 && place[next] < place[cell]));
      });
    }
    EXPECT_EQ(field.order().front(), asked.grid.index(asked.start));
  }
}

// Pell's numbers: p^2 - 2 q^2 is 1 or -1, so that q sqrt 2 is just below or just above the integer p. From
// the last of them a double's digits do not tell.
TEST(DistanceField, RoundsLengthsDownExactly) {
  EXPECT_EQ(reference::whole_part({5, 0}), 5);
  EXPECT_EQ(reference::whole_part({0, 1}), 1);
  EXPECT_EQ(reference::whole_part({3, 2}), 5);
  EXPECT_EQ(reference::whole_part({0, 2}), 2);  // 3^2 - 2 * 2^2 = 1
  EXPECT_EQ(reference::whole_part({0, 5}), 7);  // 7^2 - 2 * 5^2 = -1
  EXPECT_EQ(reference::whole_part({0, 12}), 16);
  EXPECT_EQ(reference::whole_part({0, 15'994'428}), 22'619'536);
  EXPECT_EQ(reference::whole_part({7, 38'613'965}), 54'608'400);
  EXPECT_EQ(reference::whole_part({0, 93'222'358}), 131'836'322);
}

TEST(DistanceField, StopsOnceTheTargetIsFinal) {
  const Terrain terrain = testing::terrain_of(OccupancyGrid(200, 200));
  const DistanceField field(terrain, {0, 0}, Cell{10, 0});
  EXPECT_EQ(field.length({10, 0}), (LatticeLength{10, 0}));
  EXPECT_LT(field.order().size(), 200U);
}

}  // namespace
}  // namespace pathrace
