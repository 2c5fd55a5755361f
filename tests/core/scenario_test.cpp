#include "core/scenario.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/path.hpp"
#include "tests/support/maps.hpp"

namespace pathrace {
namespace {

Scenario scenario(const OccupancyGrid& grid, MoveRule rule, Cell start, Cell goal) {
  Scenario asked;
  asked.id = "test/1";
  asked.terrain = testing::terrain_of(grid, rule);
  asked.start = start;
  asked.goal = goal;
  return asked;
}

std::string refusal(Cell start, Cell goal) {
  try {
    require_valid(scenario(testing::grid_of({"..#", "..."}), MoveRule::strict, start, goal));
  } catch (const InvalidScenario& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Scenario, NeedsAFreeStartAndAFreeGoalOnTheMap) {
  EXPECT_EQ(refusal({0, 0}, {2, 1}), "accepted");
  EXPECT_EQ(refusal({0, 0}, {0, 0}), "accepted");
  EXPECT_EQ(refusal({2, 0}, {0, 0}), "test/1: start 2,0 is a blocked cell; expected a free one");
  EXPECT_EQ(refusal({0, 0}, {2, 0}), "test/1: goal 2,0 is a blocked cell; expected a free one");
  EXPECT_EQ(refusal({3, 0}, {0, 0}), "test/1: start 3,0 is outside the 3x2 map; expected 0,0 to 2,1");
  EXPECT_EQ(refusal({0, 0}, {0, -1}), "test/1: goal 0,-1 is outside the 3x2 map; expected 0,0 to 2,1");
}

TEST(ContentHash, IsOfTheQuestionWhateverItIsCalledOrKnownAboutIt) {
  Scenario a = scenario(OccupancyGrid(3, 3), MoveRule::strict, {0, 0}, {2, 2});
  Scenario b = a;
  b.id = "another/name";
  b.optimum = {true, LatticeLength{0, 2}};
  b.terrain = testing::terrain_of(OccupancyGrid(3, 3));
  EXPECT_EQ(content_hash(a), content_hash(b));
}

TEST(ContentHash, ChangesWithRuleStartGoalAndShape) {
  std::set<std::uint64_t> hashes;
  for (const MoveRule rule : testing::all_rules) {
    hashes.insert(content_hash(scenario(OccupancyGrid(3, 3), rule, {0, 0}, {2, 2})));
  }
  hashes.insert(content_hash(scenario(OccupancyGrid(3, 3), MoveRule::strict, {1, 0}, {2, 2})));
  hashes.insert(content_hash(scenario(OccupancyGrid(3, 3), MoveRule::strict, {0, 1}, {2, 2})));
  hashes.insert(content_hash(scenario(OccupancyGrid(3, 3), MoveRule::strict, {0, 0}, {1, 2})));
  hashes.insert(content_hash(scenario(OccupancyGrid(3, 3), MoveRule::strict, {0, 0}, {2, 1})));
  hashes.insert(content_hash(scenario(OccupancyGrid(3, 3), MoveRule::strict, {2, 2}, {0, 0})));
  hashes.insert(content_hash(scenario(OccupancyGrid(3, 4), MoveRule::strict, {0, 0}, {2, 2})));
  hashes.insert(content_hash(scenario(OccupancyGrid(4, 3), MoveRule::strict, {0, 0}, {2, 2})));
  EXPECT_EQ(hashes.size(), 11U);
}

// 70 columns: the cells of a row are packed into more than one word.
TEST(ContentHash, ChangesWithEveryCell) {
  std::set<std::uint64_t> hashes;
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 70; ++x) {
      OccupancyGrid grid(70, 3);
      grid.block({x, y});
      hashes.insert(content_hash(scenario(grid, MoveRule::strict, {0, 0}, {1, 1})));
    }
  }
  EXPECT_EQ(hashes.size(), 210U);
}

TEST(Path, OfCellsVisitsTheirCentres) {
  const Path path = lattice_path({{0, 0}, {1, 2}});
  EXPECT_EQ(path.track, Track::lattice);
  EXPECT_EQ(path.points, (std::vector<Point>{{0, 0}, {1, 2}}));
  EXPECT_TRUE(lattice_path({}).points.empty());
}

}  // namespace
}  // namespace pathrace
