// MovingAI files as we write them.
#include "scenarios/movingai/writer.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <sstream>
#include <string>

#include "core/error.hpp"
#include "scenarios/movingai/map_file.hpp"
#include "scenarios/movingai/scen_file.hpp"
#include "tests/scenarios/movingai_files.hpp"

namespace pathrace::scenarios {
namespace {

using pathrace::testing::message_of;

std::string written(const OccupancyGrid& grid) {
  std::ostringstream out;
  write_map(out, grid);
  return out.str();
}

std::string written(const std::string& map_name, const Scenario& scenario) {
  std::ostringstream out;
  write_scen(out, map_name, scenario);
  return out.str();
}

// From the upper left to the lower right corner of an empty map of 6x4 cells: two straight steps and three
// diagonal ones, 2 + 3 * 1.41421356237 = 6.24264068712.
Scenario corner_to_corner() {
  Scenario scenario;
  scenario.id = "test/corner";
  scenario.terrain = {std::make_shared<OccupancyGrid>(6, 4), MoveRule::strict};
  scenario.start = {0, 0};
  scenario.goal = {5, 3};
  scenario.optimum = {true, LatticeLength{2, 3}};
  return scenario;
}

TEST(MovingAiWriter, AMapIsItsHeaderAndItsRowsFromTheTop) {
  OccupancyGrid grid(3, 2);
  grid.block({2, 0});
  grid.block({0, 1});
  EXPECT_EQ(written(grid), "type octile\nheight 2\nwidth 3\nmap\n..@\n@..\n");
}

TEST(MovingAiWriter, AMapReadAndWrittenKeepsItsFreeAndBlockedCells) {
  const MapFile map =
      MapFile::parse("type octile\r\nwidth 7\r\nheight 2\r\nmap\r\n.GSW@OT\r\nTO@WSG.", "x.map");
  const std::string text = written(*map.ground());
  EXPECT_EQ(text, "type octile\nheight 2\nwidth 7\nmap\n...@@@@\n@@@@...\n");
  EXPECT_EQ(*MapFile::parse(text, "y.map").ground(), *map.ground());
}

TEST(MovingAiWriter, AScenIsItsVersionAndNineFieldsBetweenTabs) {
  EXPECT_EQ(written("corner.map", corner_to_corner()),
            "version 1\n1\tcorner.map\t6\t4\t0\t0\t5\t3\t6.24264069\n");
}

TEST(MovingAiWriter, AWrittenScenReadsBack) {
  const ScenQuery query = ScenFile::parse(written("my own.map", corner_to_corner()), "x.scen").queries.at(0);
  EXPECT_EQ(query.map, "my own.map");
  EXPECT_EQ(query.width, 6);
  EXPECT_EQ(query.height, 4);
  EXPECT_EQ(query.start, (Cell{0, 0}));
  EXPECT_EQ(query.goal, (Cell{5, 3}));
  EXPECT_TRUE(optimum_matches(query, LatticeLength{2, 3}.value()));
}

TEST(MovingAiWriter, TheBucketChangesAtEachMultipleOfFour) {
  Scenario scenario = corner_to_corner();
  const auto bucket = [&](std::int64_t straight) {
    scenario.optimum.length = LatticeLength{straight, 0};
    return ScenFile::parse(written("x.map", scenario), "x.scen").queries.at(0).bucket;
  };
  EXPECT_EQ(bucket(0), 0);
  EXPECT_EQ(bucket(3), 0);
  EXPECT_EQ(bucket(4), 1);
  EXPECT_EQ(bucket(7), 1);
  EXPECT_EQ(bucket(8), 2);
}

TEST(MovingAiWriter, AQueryThatEndsWhereItStartsHasOptimumZero) {
  Scenario scenario = corner_to_corner();
  scenario.goal = scenario.start;
  scenario.optimum.length = LatticeLength{0, 0};
  EXPECT_EQ(written("x.map", scenario), "version 1\n0\tx.map\t6\t4\t0\t0\t0\t0\t0.00000000\n");
}

TEST(MovingAiWriter, AScenThatNobodyHasSolvedIsRefused) {
  Scenario scenario = corner_to_corner();
  scenario.optimum = {false, LatticeLength{2, 3}};
  EXPECT_EQ(message_of<InputError>([&] { written("x.map", scenario); }),
            "test/corner: no optimum is proven; a scen file needs one");
}

TEST(MovingAiWriter, AScenWithoutAWayIsRefused) {
  Scenario scenario = corner_to_corner();
  scenario.optimum = {true, std::nullopt};
  EXPECT_EQ(message_of<InputError>([&] { written("x.map", scenario); }),
            "test/corner: there is no way; a scen file needs an optimum");
}

TEST(MovingAiWriter, AScenUnderAnotherMoveRuleIsRefused) {
  Scenario scenario = corner_to_corner();
  scenario.terrain.rule = MoveRule::free;
  EXPECT_EQ(message_of<InputError>([&] { written("x.map", scenario); }),
            "test/corner: move rule 'free'; a scen file can hold 'strict' only");
}

TEST(MovingAiWriter, AMapNameThatWouldBreakTheLineIsRefused) {
  for (const std::string name : {"", " ", "a\tb.map", "a\nb.map"}) {
    EXPECT_THROW(written(name, corner_to_corner()), InputError) << name;
  }
}

TEST(MovingAiWriter, AStreamThatFailsIsTheEnvironmentsFault) {
  std::ostringstream out;
  out.setstate(std::ios::badbit);
  EXPECT_THROW(write_map(out, OccupancyGrid(1, 1)), EnvironmentError);
  EXPECT_THROW(write_scen(out, "x.map", corner_to_corner()), EnvironmentError);
}

}  // namespace
}  // namespace pathrace::scenarios
