// The map reader on well-formed files, with everything that files in the wild do.
#include "scenarios/movingai/map_file.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace pathrace::scenarios {
namespace {

// Free cells as '.', blocked ones as '@', row by row.
std::vector<std::string> picture(const OccupancyGrid& grid) {
  std::vector<std::string> rows;
  for (int y = 0; y < grid.height(); ++y) {
    std::string& row = rows.emplace_back();
    for (int x = 0; x < grid.width(); ++x) row += grid.is_free({x, y}) ? '.' : '@';
  }
  return rows;
}

using Rows = std::vector<std::string>;

const std::string header = "type octile\nheight 2\nwidth 3\nmap\n";
const Rows two_rows = {".@.", "..@"};

void expect_two_rows(const std::string& text) {
  const MapFile map = MapFile::parse(text, "x.map");
  EXPECT_EQ(map.width(), 3);
  EXPECT_EQ(map.height(), 2);
  EXPECT_EQ(picture(*map.ground()), two_rows);
}

TEST(MovingAiMap, WidthIsTheNumberOfColumnsAndTheFirstRowIsTheUpperOne) {
  expect_two_rows(header + ".@.\n..@\n");
}

TEST(MovingAiMap, GroundIsDotGAndSWhileAtOTAndWaterAreBlocked) {
  const MapFile map = MapFile::parse("type octile\nheight 1\nwidth 7\nmap\n.GSW@OT\n", "x.map");
  EXPECT_EQ(picture(*map.ground()), Rows{"...@@@@"});
  EXPECT_EQ(picture(*map.water()), Rows{"@@@.@@@"});
}

TEST(MovingAiMap, LinesMayEndInCarriageReturnAndLineFeed) {
  expect_two_rows("type octile\r\nheight 2\r\nwidth 3\r\nmap\r\n.@.\r\n..@\r\n");
}

TEST(MovingAiMap, AByteOrderMarkIsPassedOver) {
  expect_two_rows("\xef\xbb\xbf" + header + ".@.\n..@\n");
}

TEST(MovingAiMap, LinesMayEndInCarriageReturnsAlone) {
  expect_two_rows("type octile\rheight 2\rwidth 3\rmap\r.@.\r..@\r");
}

TEST(MovingAiMap, BlanksAtTheEndOfARowDoNotCount) {
  expect_two_rows(header + ".@.   \n..@\t\r\n");
}

TEST(MovingAiMap, TheLastLineNeedsNoLineEnd) {
  expect_two_rows(header + ".@.\n..@");
  expect_two_rows(header + ".@.\r\n..@\r");
}

TEST(MovingAiMap, BlankLinesAfterTheLastRowDoNotCount) {
  expect_two_rows(header + ".@.\n..@\n\n\r\n  \n");
}

TEST(MovingAiMap, TheHeaderComesInAnyOrder) {
  const std::string body = "map\n.@.\n..@\n";
  const std::string type = "type octile\n";
  const std::string height = "height 2\n";
  const std::string width = "width 3\n";
  expect_two_rows(type + height + width + body);
  expect_two_rows(type + width + height + body);
  expect_two_rows(height + type + width + body);
  expect_two_rows(height + width + type + body);
  expect_two_rows(width + type + height + body);
  expect_two_rows(width + height + type + body);
}

TEST(MovingAiMap, HeaderLinesMayHoldTabsAndSpacesAroundTheirWords) {
  expect_two_rows("type\toctile\n height   2 \nwidth \t3\nmap \n.@.\n..@\n");
}

TEST(MovingAiMap, AQueryIsInWaterOnlyWhenBothItsEndsAre) {
  const MapFile map = MapFile::parse("type octile\nheight 1\nwidth 4\nmap\nWW..\n", "x.map");
  const Cell wet{0, 0};
  const Cell also_wet{1, 0};
  const Cell dry{2, 0};
  const Cell also_dry{3, 0};
  EXPECT_TRUE(map.is_water(wet));
  EXPECT_FALSE(map.is_water(dry));
  EXPECT_EQ(map.grid_for(wet, also_wet), map.water());
  EXPECT_EQ(map.grid_for(wet, dry), map.ground());
  EXPECT_EQ(map.grid_for(dry, wet), map.ground());
  EXPECT_EQ(map.grid_for(dry, also_dry), map.ground());
}

TEST(MovingAiMap, OutsideTheMapIsNoWater) {
  const MapFile map = MapFile::parse("type octile\nheight 1\nwidth 1\nmap\nW\n", "x.map");
  EXPECT_FALSE(map.is_water({-1, 0}));
  EXPECT_FALSE(map.is_water({0, 1}));
  EXPECT_EQ(map.grid_for({0, 0}, {9, 9}), map.ground());
}

TEST(MovingAiMap, AMapOfTheLargestSideIsRead) {
  const std::string row(16384, '.');
  const MapFile wide = MapFile::parse("type octile\nheight 1\nwidth 16384\nmap\n" + row, "x.map");
  EXPECT_EQ(wide.ground()->free_cells(), 16384);
  EXPECT_EQ(wide.water()->free_cells(), 0);
}

}  // namespace
}  // namespace pathrace::scenarios
