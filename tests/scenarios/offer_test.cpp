// What a folder of maps offers to race on.
#include "scenarios/offer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "core/error.hpp"
#include "scenarios/components.hpp"
#include "scenarios/library.hpp"
#include "scenarios/movingai/folder.hpp"
#include "tests/scenarios/movingai_files.hpp"
#include "tests/support/maps.hpp"
#include "tests/support/oracle.hpp"

namespace pathrace::scenarios {
namespace {

using testing::message_of;
using testing::TemporaryFolder;
using Ids = std::vector<std::string>;

const std::string map_3x1 = "type octile\nheight 1\nwidth 3\nmap\n...\n";
const std::string picture = "P2\n3 1\n255\n255 255 255\n";

std::string scen_of(int queries) {
  std::string scen = "version 1\n";
  for (int k = 0; k < queries; ++k) scen += "0\tx.map\t3\t1\t0\t0\t2\t0\t2\n";
  return scen;
}

bool mentions(const Offer& offer, const std::string& words) {
  return std::any_of(offer.left_out.begin(), offer.left_out.end(),
                     [&](const LeftOut& item) { return item.what.find(words) != std::string::npos; });
}

TEST(Offer, HoldsEveryKindOfMap) {
  const TemporaryFolder folder;
  folder.write("dao-map/x.map", map_3x1);
  folder.write("dao-scen/x.map.scen", scen_of(5));
  folder.write("alone.map", map_3x1);
  folder.write("room.yaml", "image: drawn.pgm\nresolution: 1\norigin: [0, 0, 0]\n");
  folder.write("drawn.pgm", picture);
  folder.write("room.bmp", "a picture beside room.yaml that it does not name");
  folder.write("photo.pgm", picture);
  folder.write("digits.csv", "0,0,1\n");
  folder.write("notes.txt", "no map\n");
  folder.write("params.yaml", "speed: 3\n");
  const Offer offer = Library(folder.path()).offer({});
  EXPECT_EQ(offer.ids, (Ids{"movingai/x/2", "movingai/x/5", "ros/room/1", "ros/room/2"}));
  const auto path = [&](const char* name) { return folder.path() / name; };
  EXPECT_EQ(offer.files, (std::vector{path("alone.map"), path("digits.csv"), path("photo.pgm")}));
  EXPECT_TRUE(mentions(offer, "room.bmp: room.yaml beside it counts"));
  EXPECT_TRUE(mentions(offer, "notes.txt:1: "));
  EXPECT_EQ(offer.left_out.size(), 2U);
}

TEST(Offer, LimitsAreKeptAndSaid) {
  const TemporaryFolder folder;
  folder.write("x.map", map_3x1);
  folder.write("x.map.scen", scen_of(5));
  folder.write("wide.txt", "0000\n");
  const Offer offer = Library(folder.path()).offer({3, 3});
  EXPECT_EQ(offer.ids.size(), 3U);
  EXPECT_TRUE(offer.files.empty());
  EXPECT_TRUE(mentions(offer, "wide.txt: 4x1 cells, above 3 a side"));
}

TEST(Offer, WhatIsBrokenIsLeftOutAndTheRestIsOffered) {
  const TemporaryFolder folder;
  folder.write("x.map", map_3x1);
  folder.write("x.map.scen", scen_of(1));
  folder.write("broken.scen", "version 3\n");
  folder.write("lost.scen", "version 1\n0\tlost.map\t3\t1\t0\t0\t2\t0\t2\n");
  folder.write("full.txt", "101\n");
  folder.write("gone.yaml", "image: gone.pgm\nresolution: 1\norigin: [0, 0, 0]\n");
  const Library library(folder.path());
  const Offer offer = library.offer({});
  EXPECT_EQ(offer.ids, Ids{"movingai/x/1"});
  for (const char* words : {"broken.scen:1:", "lost.scen:2:", "gone.yaml:1:", "full.txt: no two free"})
    EXPECT_TRUE(mentions(offer, words));
  EXPECT_EQ(library.load("movingai/x/1").goal, (Cell{2, 0}));
  EXPECT_NE(message_of<InputError>([&] { library.load("movingai/broken/1"); }).find("broken.scen:1"),
            std::string::npos);
}

TEST(Offer, TheMapInTheSiblingFolderGoesBeforeOthers) {
  const TemporaryFolder folder;
  folder.write("dao-map/x.map", map_3x1);
  folder.write("other-map/x.map", map_3x1);
  const auto scen = folder.write("dao-scen/x.map.scen", scen_of(1));
  EXPECT_EQ(find_scens(folder.path()).at(0).map, folder.path() / "dao-map/x.map");
  EXPECT_EQ(find_map(ScenFile::read(scen), std::nullopt), folder.path() / "dao-map/x.map");
  const auto stray = folder.write("stray/y.scen", "version 1\n0\ty.map\t3\t1\t0\t0\t2\t0\t2\n");
  folder.write("maps/y.map", map_3x1);
  EXPECT_EQ(find_map(ScenFile::read(stray), folder.path() / "maps"), folder.path() / "maps/y.map");
  EXPECT_NE(
      message_of<InputError>([&] { find_map(ScenFile::read(stray), std::nullopt); }).find("there is none"),
      std::string::npos);
}

TEST(LeftOut, ManyOfAKindAreOneLine) {
  std::vector<LeftOut> items = {{"cats", "Tom"}, {"dogs", "Rex"}, {"cats", "Kit"}, {"cats", "Mog"}};
  EXPECT_EQ(summary(items), (Ids{"Tom", "Kit", "Mog", "Rex"}));
  items.push_back({"cats", "Puss"});
  EXPECT_EQ(summary(items), (Ids{"Tom", "Kit", "2 more cats", "Rex"}));
}

TEST(Regions, TwoCellsAreJoinedExactlyWhenTheOracleFindsAWay) {
  for (std::uint64_t i = 0; i < 30; ++i) {
    const OccupancyGrid grid = testing::random_grid(Stream(11).fork(i), 7, 6, 0.5);
    for (const MoveRule rule : testing::all_rules) {
      const Regions regions(grid, rule);
      for (const Cell a : testing::free_cells_of(grid)) {
        for (const Cell b : testing::free_cells_of(grid)) {
          ASSERT_EQ(regions.joined(a, b), testing::oracle_reachable(grid, rule, a, b))
              << i << " " << name(rule);
        }
      }
    }
  }
}

}  // namespace
}  // namespace pathrace::scenarios
