// What a cell of a ROS map is, where it lies, and what the robot makes of it.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "scenarios/inflate.hpp"
#include "scenarios/map_reader.hpp"
#include "scenarios/ros/map_yaml.hpp"
#include "scenarios/ros/occupancy_map.hpp"
#include "scenarios/ros/ros_queries.hpp"
#include "tests/scenarios/movingai_files.hpp"
#include "tests/support/maps.hpp"

namespace pathrace::scenarios {
namespace {

using testing::TemporaryFolder;

GreyImage row_of(const std::vector<std::uint32_t>& samples, std::uint32_t white) {
  GreyImage image;
  image.width = static_cast<int>(samples.size());
  image.height = 1;
  image.white = white;
  image.samples = samples;
  return image;
}

std::vector<int> occupancies(const GreyImage& image, const OccupancyRule& rule) {
  const OccupancyMap map(image, rule, {image.width, image.height, 1, {}, 0});
  std::vector<int> values;
  for (int x = 0; x < image.width; ++x) values.push_back(map.occupancy({x, 0}));
  return values;
}

TEST(OccupancyMap, TrinaryKnowsThreeValues) {
  // p = 1 - s / 255 is 1, 0.6510, 0.6471, 0.1961 (map_saver's unknown, 205), 0.1922 and 0.
  EXPECT_EQ(occupancies(row_of({0, 89, 90, 205, 206, 255}, 255), {}),
            (std::vector<int>{100, 100, -1, -1, 0, 0}));
}

TEST(OccupancyMap, NegateTurnsBlackAndWhite) {
  // p = s / 255: 0, 0.1922, 0.1961, 0.6471, 0.6510, 1.
  OccupancyRule rule;
  rule.negate = true;
  EXPECT_EQ(occupancies(row_of({0, 49, 50, 165, 166, 255}, 255), rule),
            (std::vector<int>{0, 0, -1, -1, 100, 100}));
}

TEST(OccupancyMap, AProbabilityEqualToAThresholdLiesBetween) {
  EXPECT_EQ(occupancies(row_of({349, 350, 351, 803, 804, 805}, 1000), {}),
            (std::vector<int>{100, -1, -1, -1, -1, 0}));
  OccupancyRule rule;
  rule.free_thresh = 0;
  rule.occupied_thresh = 0;
  EXPECT_EQ(occupancies(row_of({9, 10}, 10), rule), (std::vector<int>{100, -1}));
}

TEST(OccupancyMap, SixteenBitsDecideWhereEightCouldNot) {
  // 0.65 * 65535 = 42597.75: 65535 - 42597 is below the threshold, one less above it.
  EXPECT_EQ(occupancies(row_of({22937, 22938}, 65535), {}), (std::vector<int>{100, -1}));
}

TEST(OccupancyMap, ScaleIsProportionalBetweenTheThresholds) {
  OccupancyRule rule;
  rule.mode = OccupancyMode::scale;
  rule.free_thresh = 0.25;
  rule.occupied_thresh = 0.75;
  // p = 0, 0.2, 0.3, 0.5, 0.7, 0.8: (0.3 - 0.25) / 0.5 = 10 %, and so on.
  EXPECT_EQ(occupancies(row_of({10, 8, 7, 5, 3, 2}, 10), rule), (std::vector<int>{0, 0, 10, 50, 90, 100}));
}

TEST(OccupancyMap, AnOpaquePictureWithAlphaIsTheSameMapAsWithout) {
  std::vector<std::uint32_t> samples;
  for (std::uint32_t sample = 0; sample < 256; ++sample) samples.push_back(sample);
  const GreyImage grey = row_of(samples, 255);
  GreyImage opaque = grey;
  opaque.opaque = 255;
  opaque.alpha.assign(256, 255);
  OccupancyRule rule;
  for (const OccupancyMode mode : {OccupancyMode::trinary, OccupancyMode::scale, OccupancyMode::raw}) {
    for (const double occupied : {0.65, 0.9}) {  // at 0.9 the mean of black and opaque, 0.75, is below
      rule.mode = mode;
      rule.occupied_thresh = occupied;
      EXPECT_EQ(occupancies(opaque, rule), occupancies(grey, rule));
    }
  }
}

TEST(OccupancyMap, AlphaNeverBrightens) {
  // s = 205 / 255: unknown while alpha is at least as bright, darker below: (3 * 205 + 0) / 4 / 255 = 0.603.
  GreyImage image = row_of({205, 205, 205, 205}, 255);
  image.opaque = 255;
  image.alpha = {255, 254, 205, 0};
  EXPECT_EQ(occupancies(image, {}), (std::vector<int>{-1, -1, -1, -1}));
  image.samples = {100, 100, 100, 100};  // p = 0.608; with alpha 0: 1 - 300 / 1020 = 0.706
  EXPECT_EQ(occupancies(image, {}), (std::vector<int>{-1, -1, -1, 100}));
}

TEST(OccupancyMap, AlphaDarkensInTrinaryAndHidesInScale) {
  GreyImage image = row_of({255, 255, 255, 0}, 255);
  image.opaque = 255;
  image.alpha = {255, 254, 0, 0};
  // Trinary: s = (3 + alpha) / 4, so a transparent white pixel has p = 0.25 and a transparent black one 1.
  EXPECT_EQ(occupancies(image, {}), (std::vector<int>{0, 0, -1, 100}));
  OccupancyRule rule;
  rule.mode = OccupancyMode::scale;
  EXPECT_EQ(occupancies(image, rule), (std::vector<int>{0, -1, -1, -1}));
}

TEST(OccupancyMap, RawIsTheGreyValueItself) {
  OccupancyRule rule;
  rule.mode = OccupancyMode::raw;
  rule.negate = true;  // counts for nothing
  EXPECT_EQ(occupancies(row_of({0, 1, 100, 101, 255}, 255), rule), (std::vector<int>{0, 1, 100, -1, -1}));
  EXPECT_EQ(occupancies(row_of({300, 303}, 765), rule), (std::vector<int>{100, -1}));
}

TEST(OccupancyMap, UnknownCellsFollowThePolicy) {
  // p = 1, 0.6, 0.4, 0: blocked, unknown, unknown, free.
  const OccupancyMap map(row_of({0, 4, 6, 10}, 10), {}, {4, 1, 1, {}, 0});
  EXPECT_EQ(map.unknown_cells(), 2);
  EXPECT_EQ(map.grid(UnknownPolicy::free), testing::grid_of({"#..."}));
  EXPECT_EQ(map.grid(UnknownPolicy::blocked), testing::grid_of({"###."}));
  EXPECT_EQ(map.grid(UnknownPolicy::threshold), testing::grid_of({"##.."}));
}

TEST(OccupancyMap, InScaleAndRawACellIsBlockedFromFifty) {
  OccupancyRule rule;
  rule.mode = OccupancyMode::raw;
  const OccupancyMap map(row_of({49, 50, 100, 200}, 255), rule, {4, 1, 1, {}, 0});
  EXPECT_EQ(map.grid(UnknownPolicy::free), testing::grid_of({".##."}));
  EXPECT_EQ(map.grid(UnknownPolicy::threshold), testing::grid_of({".###"}));  // no p: taken as blocked
}

TEST(MapFrame, TheOriginIsTheLowerLeftCorner) {
  const MapFrame frame{4, 3, 0.5, {-1, 2}, 0};
  EXPECT_EQ(frame.cell_at({-0.9, 2.1}), (Cell{0, 2}));
  EXPECT_EQ(frame.cell_at({0.9, 3.4}), (Cell{3, 0}));
  EXPECT_EQ(frame.cell_at({-1.1, 2.1}), std::nullopt);
  EXPECT_EQ(frame.cell_at({1.1, 2.1}), std::nullopt);
  EXPECT_EQ(frame.cell_at({0, 3.6}), std::nullopt);
  EXPECT_EQ(frame.cell_at({std::nan(""), 2.1}), std::nullopt);
  EXPECT_EQ(frame.cell_at({1e300, 2.1}), std::nullopt);
  EXPECT_DOUBLE_EQ(frame.place_of(centre({0, 2})).x, -0.75);
  EXPECT_DOUBLE_EQ(frame.place_of(centre({0, 2})).y, 2.25);
}

TEST(MapFrame, YawTurnsTheMapAboutItsOrigin) {
  // A quarter turn: the map's x axis points along the world's y, its y axis against the world's x.
  const MapFrame frame{4, 3, 1, {10, 20}, std::acos(0.0)};
  EXPECT_NEAR(frame.place_of(centre({0, 2})).x, 9.5, 1e-12);
  EXPECT_NEAR(frame.place_of(centre({0, 2})).y, 20.5, 1e-12);
  EXPECT_NEAR(frame.place_of(centre({3, 2})).x, 9.5, 1e-12);
  EXPECT_NEAR(frame.place_of(centre({3, 2})).y, 23.5, 1e-12);
  EXPECT_EQ(frame.cell_at({9.5, 23.5}), (Cell{3, 2}));
  EXPECT_EQ(frame.cell_at({10.5, 20.5}), std::nullopt);
}

TEST(MapFrame, EveryCellsCentreLiesInTheCellWhateverTheYaw) {
  for (std::uint64_t i = 0; i < 200; ++i) {
    Stream stream = Stream(7).fork(i);
    const MapFrame frame{stream.between(1, 60),
                         stream.between(1, 60),
                         0.01 + stream.uniform(),
                         {100 * stream.uniform() - 50, 100 * stream.uniform() - 50},
                         8 * stream.uniform() - 4};
    for (int n = 0; n < 20; ++n) {
      const Cell cell{stream.between(0, frame.width - 1), stream.between(0, frame.height - 1)};
      ASSERT_EQ(frame.cell_at(frame.place_of(centre(cell))), cell) << "frame " << i;
    }
  }
}

TEST(MapYaml, ReadsTheFormsOfTheWild) {
  const MapYaml yaml = MapYaml::parse(
      "free_thresh: 0\nnegate: 1\nsurvey: {by: [a, b]}\norigin: [-1, 2, \"0.5\"]\nresolution: \"0.05\"\n"
      "occupied_thresh: 0.5\nmode: \"scale\"\nimage: \"./x.pgm\"\n",
      "maps/x.yaml");
  EXPECT_EQ(yaml.image, "maps/./x.pgm");
  EXPECT_EQ(yaml.image_line, 8);
  EXPECT_EQ(yaml.resolution, 0.05);
  EXPECT_EQ(yaml.origin.x, -1);
  EXPECT_EQ(yaml.origin.y, 2);
  EXPECT_EQ(yaml.yaw, 0.5);
  EXPECT_EQ(yaml.rule.mode, OccupancyMode::scale);
  EXPECT_TRUE(yaml.rule.negate);
  EXPECT_EQ(yaml.rule.occupied_thresh, 0.5);
  EXPECT_EQ(yaml.rule.free_thresh, 0);
}

TEST(MapYaml, NegateIsANumberOrATruthValue) {
  const auto negate = [](const std::string& value) {
    return MapYaml::parse("image: x\nresolution: 1\norigin: [0, 0, 0]\nnegate: " + value, "x.yaml")
        .rule.negate;
  };
  for (const char* yes : {"1", "true", "True", "TRUE", "yes"}) EXPECT_TRUE(negate(yes)) << yes;
  for (const char* no : {"0", "false", "False", "FALSE", "no"}) EXPECT_FALSE(negate(no)) << no;
}

TEST(MapYaml, ATildeIsTheHomeFolder) {
  const char* const home = std::getenv("HOME");
  if (home == nullptr) GTEST_SKIP() << "no home folder";
  const auto image = [](const std::string& path) {
    return MapYaml::parse("image: " + path + "\nresolution: 1\norigin: [0, 0, 0]\n", "a/x.yaml").image;
  };
  EXPECT_EQ(image("~/maps/x.pgm"), std::filesystem::path(home) / "maps/x.pgm");
  EXPECT_EQ(image("~x.pgm"), "a/~x.pgm");
}

TEST(MapYaml, AByteOrderMarkIsPassedOver) {
  EXPECT_EQ(MapYaml::parse("\xef\xbb\xbfimage: x\nresolution: 2\norigin: [0, 0, 0]\n", "x.yaml").resolution,
            2);
}

TEST(MapYaml, WhatIsMissingIsAsMapServerWritesIt) {
  const MapYaml yaml = MapYaml::parse("image: /a/x.pgm\nresolution: 1\norigin: [0,0,0]\n", "x.yaml");
  EXPECT_EQ(yaml.image, "/a/x.pgm");
  EXPECT_EQ(yaml.rule.mode, OccupancyMode::trinary);
  EXPECT_FALSE(yaml.rule.negate);
  EXPECT_EQ(yaml.rule.occupied_thresh, 0.65);
  EXPECT_EQ(yaml.rule.free_thresh, 0.196);
}

// From a cell's centre to the square of side 1 around another, in half edges, squared.
int squared_half_edges(int dx, int dy) {
  const auto gap = [](int cells) { return cells == 0 ? 0 : 2 * std::abs(cells) - 1; };
  return gap(dx) * gap(dx) + gap(dy) * gap(dy);
}

TEST(Inflate, EqualsTheDefinitionOnRandomMaps) {
  for (std::uint64_t i = 0; i < 60; ++i) {
    Stream stream = Stream(8).fork(i);
    const int width = stream.between(1, 24);
    const OccupancyGrid grid = testing::random_grid(stream.fork(0), width, stream.between(1, 24), 0.05);
    const double radius = i % 10 == 0 ? 100 : 5 * stream.uniform();
    OccupancyGrid expected = grid;
    for (int y = 0; y < grid.height(); ++y) {
      for (int x = 0; x < grid.width(); ++x) {
        for (int v = 0; v < grid.height(); ++v) {
          for (int u = 0; u < grid.width(); ++u) {
            const bool near = squared_half_edges(x - u, y - v) < 4 * radius * radius;
            if (!grid.is_free({u, v}) && near) expected.block({x, y});
          }
        }
      }
    }
    ASSERT_EQ(inflated(grid, radius), expected) << "map " << i << ", radius " << radius;
  }
}

TEST(Inflate, ARobotFitsWhereItsDiscDoes) {
  const OccupancyGrid corridor = testing::grid_of({"####", "....", "....", "....", "####"});
  EXPECT_EQ(inflated(corridor, 1.5), testing::grid_of({"####", "####", "....", "####", "####"}));
  EXPECT_EQ(inflated(corridor, 0.075 / 0.05), inflated(corridor, 1.5));
  EXPECT_EQ(inflated(corridor, 0.099 / 0.05).free_cells(), 0);  // 0.198 m wide, the corridor 0.15 m
  EXPECT_EQ(inflated(corridor, 0.5), corridor);
}

TEST(Inflate, TheBorderIsNoObstacleAndWholeMultiplesCount) {
  EXPECT_EQ(inflated(OccupancyGrid(5, 4), 3), OccupancyGrid(5, 4));
  EXPECT_EQ(inflated(testing::grid_of({"#......"}), 2.5), testing::grid_of({"###...."}));
  EXPECT_EQ(inflated(testing::grid_of({"#......"}), 0.125 / 0.05), testing::grid_of({"###...."}));
  EXPECT_EQ(inflated(testing::grid_of({"#......"}), 2.51), testing::grid_of({"####..."}));
  EXPECT_THROW(inflated(OccupancyGrid(2, 2), -1), InputError);
}

TEST(ReadMap, TheRadiusIsInMetres) {
  const TemporaryFolder folder;
  folder.write("x.pgm", "P2\n7 1\n255\n0 255 255 255 205 255 255\n");
  const auto yaml = folder.write("x.yaml", "image: x.pgm\nresolution: 0.5\norigin: [1, 2, 0]\n");
  MapOptions options;
  options.radius = 1;
  options.unknown = UnknownPolicy::free;
  EXPECT_EQ(*read_map(yaml, options).grid, testing::grid_of({"###...."}));
  options.resolution = 0.25;
  EXPECT_EQ(*read_map(folder.path() / "x.pgm", options).grid, testing::grid_of({"#####.."}));
  EXPECT_EQ(*read_map(yaml).grid, testing::grid_of({"#...#.."}));
  EXPECT_EQ(read_map(yaml).frame.origin.y, 2);
  EXPECT_EQ(read_map(yaml).unknown_cells, 1);
}

}  // namespace
}  // namespace pathrace::scenarios
