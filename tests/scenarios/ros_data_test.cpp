// The readers on real ROS maps. Sizes, resolutions and origins were read from the yaml files by a person; the
// cells were counted independently, by a few lines of Python over the files (fractions against thresholds),
// never by the readers.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <sstream>
#include <string>

#include "scenarios/library.hpp"
#include "scenarios/map_reader.hpp"
#include "scenarios/movingai/map_file.hpp"
#include "scenarios/movingai/writer.hpp"
#include "scenarios/ros/map_yaml.hpp"
#include "tests/support/data_folder.hpp"

namespace pathrace::scenarios {
namespace {

namespace fs = std::filesystem;

struct RosMapFacts {
  std::string yaml;
  int width;
  int height;
  double resolution;
  WorldPoint origin;
  double yaw;
  std::int64_t free;
  std::int64_t occupied;
  std::int64_t unknown;
};

class RosData : public ::testing::Test {
 protected:
  void SetUp() override {
    const std::optional<fs::path> data = pathrace::testing::data_folder();
    if (!data) GTEST_SKIP() << pathrace::testing::without_data;
    data_ = *data;
  }
  fs::path data_;
};

std::int64_t count(const OccupancyMap& map, int value) {
  std::int64_t cells = 0;
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) cells += map.occupancy({x, y}) == value ? 1 : 0;
  }
  return cells;
}

TEST_F(RosData, EveryYamlLoadsWithItsPlaceAndItsCells) {
  const std::vector<RosMapFacts> facts = {
      {"nav2_TenByTen/TenByTen.yaml", 10, 10, 1.0, {0, 0}, 0, 78, 20, 2},
      {"nav2_keepout_mask/keepout_mask.yaml", 384, 384, 0.05, {-10, -10}, 0, 8690, 171, 138595},
      {"nav2_map_circular/map_circular.yaml", 384, 384, 0.05, {-10, -10}, 0, 7930, 920, 138606},
      {"nav2_tb3_sandbox/tb3_sandbox.yaml", 384, 384, 0.05, {-10, -10}, 0, 7903, 870, 138683},
      {"nav2_testmap/testmap.yaml", 10, 10, 0.1, {2, 3}, 1, 71, 29, 0},
      {"roomba_lse_arena/lse_arena.yaml", 80, 60, 0.05, {0, 0}, 0, 4455, 345, 0},
      {"teb_maze/maze.yaml", 200, 200, 0.05, {0, 0}, 0, 38506, 1494, 0},
      {"turtlebot3_world/map.yaml", 384, 384, 0.05, {-10, -10}, 0, 7939, 795, 138722},
  };
  for (const RosMapFacts& fact : facts) {
    SCOPED_TRACE(fact.yaml);
    const OccupancyMap map = read_ros_map(data_ / "ros" / fact.yaml);
    EXPECT_EQ(map.width(), fact.width);
    EXPECT_EQ(map.height(), fact.height);
    EXPECT_EQ(map.frame().resolution, fact.resolution);
    EXPECT_EQ(map.frame().origin.x, fact.origin.x);
    EXPECT_EQ(map.frame().origin.y, fact.origin.y);
    EXPECT_EQ(map.frame().yaw, fact.yaw);
    EXPECT_EQ(count(map, 0), fact.free);
    EXPECT_EQ(count(map, 100), fact.occupied);
    EXPECT_EQ(map.unknown_cells(), fact.unknown);
    EXPECT_EQ(map.grid(UnknownPolicy::blocked).free_cells(), fact.free);
    EXPECT_EQ(map.grid(UnknownPolicy::free).free_cells(), fact.free + fact.unknown);
  }
}

TEST_F(RosData, TheSpeedMaskIsInScale) {
  // Greys 254, 205 and 128; 205 is (1 - 205/255 - 0.01) / 0.98 = 18.99 %, 128 is 49.8 %.
  const OccupancyMap map = read_ros_map(data_ / "ros/nav2_speed_mask/speed_mask.yaml");
  EXPECT_EQ(map.width(), 384);
  EXPECT_EQ(map.frame().resolution, 0.05);
  EXPECT_EQ(map.frame().origin.x, -10);
  EXPECT_EQ(count(map, 0), 8690);
  EXPECT_EQ(count(map, 19), 138595);
  EXPECT_EQ(count(map, 50), 171);
  EXPECT_EQ(map.unknown_cells(), 0);
}

TEST_F(RosData, APictureWithoutYamlLoadsWithAGivenResolution) {
  MapOptions options;
  options.resolution = 0.1;
  const GridMap map = read_map(data_ / "ros/stage_willow-full/willow-full.pgm", options);
  EXPECT_EQ(map.frame.width, 584);
  EXPECT_EQ(map.frame.height, 526);
  EXPECT_EQ(map.frame.resolution, 0.1);
  EXPECT_EQ(map.grid->free_cells(), 134715);
  EXPECT_EQ(map.unknown_cells, 165508);
  options.unknown = UnknownPolicy::free;
  EXPECT_EQ(read_map(data_ / "ros/stage_willow-full/willow-full.pgm", options).grid->free_cells(),
            584 * 526 - 6961);
}

TEST_F(RosData, OneMapInThreeFormatsIsOneGrid) {
  const fs::path folder = data_ / "ros/nav2_testmap";
  const GridMap png = read_map(folder / "testmap.png");
  EXPECT_FALSE(png.grid->is_free({0, 0}));  // blocked cells of the first two rows: 0,0 0,1 6,1 7,1
  EXPECT_TRUE(png.grid->is_free({1, 0}));
  EXPECT_FALSE(png.grid->is_free({6, 1}));
  EXPECT_TRUE(png.grid->is_free({9, 9}));
  EXPECT_EQ(*read_map(folder / "testmap.pgm").grid, *png.grid);
  EXPECT_EQ(*read_map(folder / "testmap.bmp").grid, *png.grid);
  EXPECT_EQ(*read_map(folder / "testmap.yaml").grid, *png.grid);
}

TEST_F(RosData, TheLibraryAsksQuestionsOnEveryMap) {
  const Library library(data_ / "ros");
  const std::vector<std::string> ids = library.select("ros/*/1..2");
  EXPECT_EQ(ids.size(), 18U);
  for (const std::string& id : ids) {
    Scenario scenario = library.load(id);
    prove(scenario);
    EXPECT_TRUE(scenario.optimum.length) << id;
  }
  EXPECT_NO_THROW(Library(data_ / "movingai").load("ros/maze/1"));  // from the folder beside
}

// The writer knows two letters: ground is '.', all else '@'; lines end in LF.
std::string canonical(std::string text) {
  text.erase(std::remove(text.begin(), text.end(), '\r'), text.end());
  if (!text.ends_with('\n')) text += '\n';
  const std::size_t body = text.find("map\n") + 4;
  for (std::size_t i = body; i < text.size(); ++i) {
    if (text[i] == 'G' || text[i] == 'S') text[i] = '.';
    if (text[i] == 'O' || text[i] == 'T' || text[i] == 'W') text[i] = '@';
  }
  return text;
}

TEST_F(RosData, EveryMapFileReadAndWrittenIsTheSameBytesButForLineEndsAndLetters) {
  int files = 0;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(data_)) {
    if (entry.path().extension() != ".map") continue;
    ++files;
    std::ifstream in(entry.path(), std::ios::binary);
    const std::string text((std::istreambuf_iterator<char>(in)), {});
    std::ostringstream out;
    write_map(out, *MapFile::read(entry.path()).ground());
    EXPECT_EQ(out.str(), canonical(text)) << entry.path();
  }
  EXPECT_GE(files, 29);
}

}  // namespace
}  // namespace pathrace::scenarios
