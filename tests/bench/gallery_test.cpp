// Pictures on the command line, and what the gallery shows of each family.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <set>
#include <sstream>

#include "bench/gallery_tiles.hpp"
#include "results/polyline.hpp"
#include "tests/bench/command_line.hpp"
#include "tests/support/png_picture.hpp"

namespace pathrace::bench {
namespace {

using testing::Finished;
using testing::ScratchFolder;

std::string text_of(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

void expect_one_line(const Finished& finished, int code, const std::vector<std::string>& words) {
  EXPECT_EQ(finished.exit_code, code) << finished.err;
  EXPECT_EQ(finished.out, "");
  EXPECT_EQ(std::count(finished.err.begin(), finished.err.end(), '\n'), 1) << finished.err;
  for (const std::string& word : words) EXPECT_NE(finished.err.find(word), std::string::npos) << finished.err;
}

scenarios::Family family_of(const std::vector<std::string>& ids) {
  scenarios::Family family;
  family.name = "dense";
  family.library = ids;
  return family;
}

TEST(GalleryTiles, AFamilyShowsItsLastListedMapsOfMiddleSize) {
  const auto ids = [](const std::vector<std::string>& library, std::size_t count) {
    return gallery_ids(family_of(library), count);
  };
  using Ids = std::vector<std::string>;
  EXPECT_EQ(ids({"dense/10-10/1", "dense/20-10/1", "dense/20-20/1", "dense/20-20/2"}, 1),
            Ids{"dense/20-20/1"});
  EXPECT_EQ(ids({"dense/20-10/1", "dense/20-20/1", "dense/20-20/2"}, 3),
            (Ids{"dense/20-20/1", "dense/20-20/2"}));
  EXPECT_EQ(ids({"dense/24-10/1", "dense/64-10/1"}, 1), Ids{"dense/24-10/1"});  // 64 is too large,
  EXPECT_EQ(ids({"dense/40-10/1", "dense/64-10/1"}, 1), Ids{"dense/40-10/1"});  // 40 is nearer to 32
  EXPECT_EQ(ids({"dense/5-10/1", "dense/10-10/1"}, 1), Ids{"dense/10-10/1"});   // 10 is nearer to 20
  EXPECT_EQ(ids({}, 1), Ids{});
}

TEST(GalleryTiles, EveryFamilyIsThereAndMapsHaveAShortestPath) {
  std::set<std::string> names;
  for (const results::Tile& tile : gallery_tiles(1)) {
    names.insert(tile.title);
    EXPECT_FALSE(tile.caption.empty()) << tile.title;
    if (tile.scenario.world) continue;  // no shortest path among what moves
    ASSERT_TRUE(tile.scenario.optimum.proven) << tile.scenario.id;
    ASSERT_EQ(tile.answer.has_value(), tile.scenario.optimum.length.has_value()) << tile.scenario.id;
    if (!tile.answer) continue;
    EXPECT_NEAR(results::polyline_length(tile.answer->points), tile.scenario.optimum.length->value(), 1e-9);
  }
  EXPECT_EQ(names.size(), scenarios::families().size());
}

TEST(PicturesOnTheCommandLine, ShowWritesThePictureThatTheExtensionNames) {
  const ScratchFolder scratch;
  EXPECT_EQ(pathrace({"scenarios", "show", "trap-u/20/3", "-o", scratch / "u.png"}).exit_code, 0);
  EXPECT_EQ(pathrace({"scenarios", "show", "trap-u/20/3", "-o", scratch / "u.svg"}).exit_code, 0);
  EXPECT_TRUE(testing::png_header(text_of(scratch / "u.png")).signature);
  EXPECT_TRUE(text_of(scratch / "u.svg").starts_with("<?xml"));
  EXPECT_NE(text_of(scratch / "u.svg").find(">trap-u/20/3</text>"), std::string::npos);
}

TEST(PicturesOnTheCommandLine, PlanDrawsPixelsToo) {
  const ScratchFolder scratch;
  EXPECT_EQ(pathrace({"plan", "--scenario", "asr/fig2", "--planner", "astar", "--png", scratch / "p.png",
                      "--svg", scratch / "p.svg"})
                .exit_code,
            0);
  EXPECT_TRUE(testing::png_header(text_of(scratch / "p.png")).signature);
  EXPECT_TRUE(text_of(scratch / "p.svg").starts_with("<?xml"));
}

TEST(PicturesOnTheCommandLine, TheGalleryNamesEveryFamily) {
  const ScratchFolder scratch;
  EXPECT_EQ(pathrace({"scenarios", "gallery", "-o", scratch / "g.html"}).exit_code, 0);
  EXPECT_EQ(pathrace({"scenarios", "gallery", "-o", scratch / "g.svg"}).exit_code, 0);
  EXPECT_EQ(pathrace({"scenarios", "gallery", "-o", scratch / "g.png"}).exit_code, 0);
  const std::string page = text_of(scratch / "g.html");
  const std::string sheet = text_of(scratch / "g.svg");
  for (const scenarios::Family& family : scenarios::families()) {
    EXPECT_NE(page.find('>' + family.name + "</h2>"), std::string::npos) << family.name;
    EXPECT_NE(sheet.find('>' + family.name + "</text>"), std::string::npos) << family.name;
  }
  EXPECT_EQ(testing::png_header(text_of(scratch / "g.png")).width, 1200U);
}

TEST(PicturesOnTheCommandLine, OtherExtensionsAreRefused) {
  const ScratchFolder scratch;
  expect_one_line(pathrace({"scenarios", "show", "asr/fig2", "-o", scratch / "a.jpg"}), 2,
                  {"a.jpg", ".png or .svg"});
  expect_one_line(pathrace({"scenarios", "gallery", "-o", scratch / "a"}), 2, {"/a:", ".html, .png or .svg"});
}

TEST(PicturesOnTheCommandLine, FilesThatCannotBeWrittenAreTheEnvironmentsFault) {
  const ScratchFolder scratch;
  const std::string nowhere = scratch / "none";
  expect_one_line(pathrace({"scenarios", "show", "asr/fig2", "-o", nowhere + "/a.png"}), 3, {"none/a.png"});
  expect_one_line(pathrace({"scenarios", "gallery", "-o", nowhere + "/a.html"}), 3, {"none/a.html"});
}

}  // namespace
}  // namespace pathrace::bench
