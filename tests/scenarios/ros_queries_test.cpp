// Questions on ROS maps, from an id of the library.
#include "scenarios/ros/ros_queries.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "core/error.hpp"
#include "scenarios/library.hpp"
#include "tests/scenarios/movingai_files.hpp"

namespace pathrace::scenarios {
namespace {

using testing::message_of;
using testing::TemporaryFolder;

// Two regions: the left one of 2 x 3 cells, the right one of 1 x 3; the corner between them is unknown.
void write_map(const TemporaryFolder& folder, const std::string& stem) {
  folder.write(stem + ".pgm", "P2\n4 3\n255\n255 255 0 255\n255 255 0 255\n255 255 205 255\n");
  const std::string image = stem.substr(stem.rfind('/') + 1) + ".pgm";
  folder.write(stem + ".yaml", "image: " + image + "\nresolution: 1\norigin: [0, 0, 0]\n");
}

TEST(RosQueries, EndsAreTwoCellsOfTheLargestRegion) {
  const TemporaryFolder folder;
  write_map(folder, "deep/er/yard");
  const Library library(folder.path());
  std::set<Cell> starts;
  std::set<Cell> goals;
  for (int k = 1; k <= 200; ++k) {
    const Scenario scenario = library.load("ros/yard/" + std::to_string(k));
    EXPECT_EQ(scenario.terrain.rule, MoveRule::strict);
    EXPECT_NE(scenario.start, scenario.goal);
    EXPECT_LT(scenario.start.x, 2);
    EXPECT_LT(scenario.goal.x, 2);
    EXPECT_EQ(scenario.grid().free_cells(), 9);
    starts.insert(scenario.start);
    goals.insert(scenario.goal);
  }
  EXPECT_EQ(starts.size(), 6U);
  EXPECT_EQ(goals.size(), 6U);
}

TEST(RosQueries, AQuestionIsTheSameForEver) {
  const TemporaryFolder folder;
  write_map(folder, "yard");
  const Scenario one = Library(folder.path()).load("ros/yard/7");
  const Library library(folder.path());
  library.load("ros/yard/1");
  const Scenario again = library.load("ros/yard/7");
  EXPECT_EQ(one.start, again.start);
  EXPECT_EQ(one.goal, again.goal);
  EXPECT_EQ(content_hash(one), content_hash(again));
}

TEST(RosQueries, RangesAndGlobsStandForQuestions) {
  const TemporaryFolder folder;
  write_map(folder, "yard");
  write_map(folder, "hall");
  const Library library(folder.path());
  EXPECT_EQ(library.select("ros/yard/2..3"), (std::vector<std::string>{"ros/yard/2", "ros/yard/3"}));
  EXPECT_EQ(library.select("ros/*/1"), (std::vector<std::string>{"ros/hall/1", "ros/yard/1"}));
  EXPECT_EQ(library.select("ros/*/*").size(), 60U);
}

TEST(RosQueries, MapsOfOneNameAreToldApartByTheirFolders) {
  const TemporaryFolder folder;
  write_map(folder, "a/map");
  write_map(folder, "b/map");
  write_map(folder, "b/other");
  folder.write("b/params.yaml", "speed: 3\n");  // not a map
  const std::vector<RosMapEntry> maps = find_ros_maps(folder.path());
  ASSERT_EQ(maps.size(), 3U);
  EXPECT_EQ(maps[0].name, "a-map");
  EXPECT_EQ(maps[1].name, "b-map");
  EXPECT_EQ(maps[2].name, "other");
  write_map(folder, "deeper/a/map");
  EXPECT_NE(message_of<InputError>([&] { find_ros_maps(folder.path()); }).find("is named 'a-map', as is"),
            std::string::npos);
}

TEST(RosQueries, MapsMayLieInTheFolderBeside) {
  const TemporaryFolder folder;
  folder.write("movingai/empty.txt", "");
  write_map(folder, "ros/yard");
  EXPECT_EQ(find_ros_maps(folder.path() / "movingai").size(), 1U);
}

TEST(RosQueries, ANameThatCommandsTheTerminalIsRefused) {
  const TemporaryFolder folder;
  write_map(folder, "two\nlines");
  const std::string message = message_of<InputError>([&] { find_ros_maps(folder.path()); });
  EXPECT_NE(message.find("is named 'two\\x0alines'"), std::string::npos) << message;
}

TEST(RosQueries, FaultsAreNamed) {
  const TemporaryFolder folder;
  write_map(folder, "yard");
  folder.write("broken.yaml", "image: gone.pgm\nresolution: 1\norigin: [0, 0, 0]\n");
  folder.write("full.pgm", "P2\n2 1\n255\n0 255\n");
  folder.write("full.yaml", "image: full.pgm\nresolution: 1\norigin: [0, 0, 0]\n");
  const Library library(folder.path());
  const auto says = [&](const std::string& id) { return message_of<InputError>([&] { library.load(id); }); };
  EXPECT_NE(says("ros/yart/1").find("'yard'"), std::string::npos);
  EXPECT_NE(says("ros/yard/0").find("1.."), std::string::npos);
  EXPECT_NE(says("ros/yard").find("ros/<map>/<k>"), std::string::npos);
  EXPECT_NE(says("ros/broken/1").find("broken.yaml:1: image"), std::string::npos);
  EXPECT_NE(says("ros/full/1").find("1 free cells; expected 2"), std::string::npos);
  EXPECT_NE(message_of<InputError>([] { Library().load("ros/yard/1"); }).find("--maps"), std::string::npos);
}

}  // namespace
}  // namespace pathrace::scenarios
