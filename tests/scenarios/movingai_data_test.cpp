// The readers on the real files of the MovingAI benchmarks. The numbers expected here were counted by other
// means (a few lines of Python over the files), never by the readers.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "scenarios/movingai/folder.hpp"
#include "scenarios/movingai/map_file.hpp"
#include "scenarios/movingai/scen_file.hpp"
#include "scenarios/movingai/writer.hpp"
#include "tests/support/data_folder.hpp"

namespace pathrace::scenarios {
namespace {

namespace fs = std::filesystem;

class MovingAiData : public ::testing::Test {
 protected:
  void SetUp() override {
    const std::optional<fs::path> data = pathrace::testing::data_folder();
    if (!data) GTEST_SKIP() << pathrace::testing::without_data;
    folder_ = *data / "movingai";
  }

  std::vector<fs::path> maps() const {
    std::vector<fs::path> found;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder_)) {
      if (entry.path().extension() == ".map") found.push_back(entry.path());
    }
    return found;
  }

  fs::path folder_;
};

TEST_F(MovingAiData, All31ScenFilesLoadWith23419Queries) {
  const std::vector<ScenEntry> scens = find_scens(folder_);
  EXPECT_EQ(scens.size(), 31U);
  std::map<std::string, std::size_t> queries;
  std::size_t total = 0;
  for (const ScenEntry& entry : scens) {
    queries[entry.name] = ScenFile::read(entry.scen).queries.size();
    total += queries[entry.name];
  }
  EXPECT_EQ(total, 23419U);
  EXPECT_EQ(queries["arena"], 160U);
  EXPECT_EQ(queries["AR0011SR"], 1280U);
  EXPECT_EQ(queries["Berlin_0_256"], 930U);
  EXPECT_EQ(queries["empty-8-8-even-1"], 32U);
  EXPECT_EQ(queries["maze512-32-7"], 4690U);
}

TEST_F(MovingAiData, All29MapsLoadWithTheirFreeCells) {
  const std::vector<fs::path> files = maps();
  EXPECT_EQ(files.size(), 29U);
  std::map<std::string, std::int64_t> ground;
  std::int64_t water = 0;
  std::int64_t cells = 0;
  for (const fs::path& file : files) {
    const MapFile map = MapFile::read(file);
    ground[file.stem().string()] = map.ground()->free_cells();
    water += map.water()->free_cells();
    cells += std::int64_t{map.width()} * map.height();
  }
  EXPECT_EQ(cells, 2106100);
  EXPECT_EQ(water, 650);
  EXPECT_EQ(ground["arena"], 2054);
  EXPECT_EQ(ground["Berlin_0_256"], 48147);
  EXPECT_EQ(ground["smalltrap"], 60 + 36);
  EXPECT_EQ(ground["random512-25-5"], 195352);
}

TEST_F(MovingAiData, EveryScenAgreesWithItsMapOnTheSizeAndStaysInsideIt) {
  for (const ScenEntry& entry : find_scens(folder_)) {
    const MapFile map = MapFile::read(entry.map);
    for (const ScenQuery& query : ScenFile::read(entry.scen).queries) {
      ASSERT_EQ(query.width, map.width()) << entry.name << ":" << query.line;
      ASSERT_EQ(query.height, map.height()) << entry.name << ":" << query.line;
      const auto grid = map.grid_for(query.start, query.goal);
      ASSERT_EQ(grid, map.ground()) << entry.name << ":" << query.line;
      ASSERT_TRUE(grid->is_free(query.start)) << entry.name << ":" << query.line;
      ASSERT_TRUE(grid->is_free(query.goal)) << entry.name << ":" << query.line;
    }
  }
}

TEST_F(MovingAiData, NoWayIsShorterThanItsOptimumAllows) {
  // The octile distance, the length on an empty map, is a lower bound of every optimum.
  std::size_t same_ends = 0;
  for (const ScenEntry& entry : find_scens(folder_)) {
    for (const ScenQuery& query : ScenFile::read(entry.scen).queries) {
      const int dx = std::abs(query.start.x - query.goal.x);
      const int dy = std::abs(query.start.y - query.goal.y);
      const double octile = LatticeLength{std::abs(dx - dy), std::min(dx, dy)}.value();
      ASSERT_LE(octile, query.optimum + optimum_tolerance(query, octile)) << entry.name << ":" << query.line;
      if (dx == 0 && dy == 0) {
        ++same_ends;
        EXPECT_TRUE(optimum_matches(query, 0));
      }
    }
  }
  EXPECT_EQ(same_ends, 2U);
}

TEST_F(MovingAiData, OnAnEmptyMapEveryOptimumIsTheOctileDistance) {
  for (const ScenEntry& entry : find_scens(folder_)) {
    if (entry.name.rfind("empty-", 0) != 0) continue;
    for (const ScenQuery& query : ScenFile::read(entry.scen).queries) {
      const int dx = std::abs(query.start.x - query.goal.x);
      const int dy = std::abs(query.start.y - query.goal.y);
      const LatticeLength octile{std::abs(dx - dy), std::min(dx, dy)};
      EXPECT_TRUE(optimum_matches(query, octile.value())) << entry.name << ":" << query.line;
    }
  }
}

TEST_F(MovingAiData, PacmanIsAMazeInAPond) {
  const MapFile map = MapFile::read(folder_ / "local" / "pacman.map");
  EXPECT_EQ(map.width(), 43);
  EXPECT_EQ(map.height(), 31);
  EXPECT_EQ(map.water()->free_cells(), 650);
  EXPECT_EQ(map.ground()->free_cells(), 303 + 8);
  EXPECT_FALSE(map.is_water({5, 0}));  // the first row is TTTTTTWW...
  EXPECT_TRUE(map.is_water({6, 0}));
  EXPECT_TRUE(map.ground()->is_free({8, 1}));  // the second TTTTTTWW....
  EXPECT_EQ(map.grid_for({6, 0}, {7, 1}), map.water());
  EXPECT_EQ(map.grid_for({6, 0}, {8, 1}), map.ground());
  EXPECT_EQ(map.grid_for({8, 1}, {9, 1}), map.ground());
}

TEST_F(MovingAiData, EveryMapReadWrittenAndReadAgainIsTheSame) {
  for (const fs::path& file : maps()) {
    const MapFile map = MapFile::read(file);
    std::ostringstream out;
    write_map(out, *map.ground());
    EXPECT_EQ(*MapFile::parse(out.str(), "copy.map").ground(), *map.ground()) << file;
  }
}

}  // namespace
}  // namespace pathrace::scenarios
