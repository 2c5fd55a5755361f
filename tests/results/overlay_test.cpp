// What a planner thought, in pictures.
#include <gtest/gtest.h>

#include <sstream>

#include "results/canvas_overlay.hpp"
#include "results/overlay_style.hpp"
#include "results/svg.hpp"
#include "tests/support/maps.hpp"
#include "tests/support/xml_fault.hpp"

namespace pathrace::results {
namespace {

using pathrace::testing::grid_of;
using pathrace::testing::terrain_of;

Scenario question() {
  Scenario scenario;
  scenario.id = "test";
  scenario.terrain = terrain_of(grid_of({"...", ".#.", "..."}));
  scenario.goal = {2, 2};
  return scenario;
}

Overlay overlay() {
  return {{{{1, 1}, 0.75}}, {{0, 0}, {1, 1}, {2, 2}}, {}, {1, 1, 1, 1, 0, 5, 1, 1, 5}};
}

std::string svg(const Overlay& drawn) {
  std::ostringstream out;
  write_svg(out, question(), {.title = "a title", .overlay = drawn});
  return out.str();
}

TEST(Shades, RunFromTheLeastPositiveValueToTheGreatest) {
  EXPECT_EQ(shades_of({0, 1, 2, 5}),
            (std::vector<int>{0, 0, most_shade / 2, most_shade}));  // sqrt(1/4) = 1/2
  EXPECT_EQ(shades_of({3, 3, 0}), (std::vector<int>{0, 0, 0}));
  EXPECT_EQ(shades_of({}), (std::vector<int>{}));
}

TEST(SvgOverlay, DrawsFieldCirclesAndLine) {
  const std::string picture = svg(overlay());
  EXPECT_EQ(pathrace::testing::xml_fault(picture), "");
  EXPECT_NE(picture.find("d=\"M2 1h1v1h-1zM2 2h1v1h-1z\""), std::string::npos) << picture;
  EXPECT_NE(picture.find("cx=\"1\" cy=\"1\" r=\"0.75\""), std::string::npos);
  EXPECT_NE(picture.find("points=\"0,0 1,1 2,2\""), std::string::npos);
}

TEST(SvgOverlay, WithoutOneThePictureIsAsBefore) {
  const std::string picture = svg({});
  EXPECT_EQ(picture.find("class=\"field\""), std::string::npos);
  EXPECT_EQ(picture.find("stroke-dasharray"), std::string::npos);
}

TEST(CanvasOverlay, ShadesFreeCellsByTheirValue) {
  const OccupancyGrid grid = grid_of({"..#"});
  Canvas canvas(30, 10, palette.ground);
  paint_field(canvas, {0, 0, 10}, {{}, {}, {}, {1, 5, 5}}, grid);
  EXPECT_EQ(canvas.at(5, 5), palette.ground);   // the least value
  EXPECT_EQ(canvas.at(25, 5), palette.ground);  // blocked
  EXPECT_LT(canvas.at(15, 5).blue, 0x60);       // amber, nine tenths of it
}

TEST(CanvasOverlay, DrawsTheCirclesOfThePlanner) {
  Canvas canvas(30, 30, palette.ground);
  paint_shapes(canvas, {0, 0, 10}, {{{{1, 1}, 1}}, {}, {}, {}});
  EXPECT_NE(canvas.at(25, 15), palette.ground);  // centre at 15,15, radius 10
  EXPECT_EQ(canvas.at(15, 15), palette.ground);
}

TEST(CanvasOverlay, DashesTheLineOfThePlanner) {
  Canvas canvas(60, 10, palette.ground);
  paint_shapes(canvas, {0, 0, 10}, {{}, {{0, 0}, {4, 0}}, {}, {}});  // from 5 to 45; pieces of 4 x 1.5
  EXPECT_NE(canvas.at(7, 5), palette.ground);
  EXPECT_EQ(canvas.at(14, 5), palette.ground);
  EXPECT_NE(canvas.at(20, 5), palette.ground);
}

TEST(Dashes, AreEveryOtherPieceAndGoRoundCorners) {
  const std::vector<Segment> dashes = dashes_of({{0, 0}, {3, 0}, {3, 9}}, 2);  // 12 long
  ASSERT_EQ(dashes.size(), 3U);
  EXPECT_EQ(dashes[0].from, (Point{0, 0}));
  EXPECT_EQ(dashes[0].to, (Point{2, 0}));
  EXPECT_EQ(dashes[1].from, (Point{3, 1}));
  EXPECT_EQ(dashes[1].to, (Point{3, 3}));
  EXPECT_EQ(dashes[2].from, (Point{3, 5}));
  EXPECT_EQ(dashes[2].to, (Point{3, 7}));
  EXPECT_TRUE(dashes_of({{1, 1}}, 2).empty());
}

}  // namespace
}  // namespace pathrace::results
