#include "results/png.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <sstream>

#include "core/error.hpp"
#include "results/picture.hpp"
#include "results/picture_png.hpp"
#include "tests/support/maps.hpp"
#include "tests/support/png_picture.hpp"

namespace pathrace::results {
namespace {

using pathrace::testing::grid_of;
using pathrace::testing::Pixels;
using pathrace::testing::png_header;
using pathrace::testing::png_pixels;
using pathrace::testing::terrain_of;

Scenario scenario_on(const OccupancyGrid& grid, Cell start, Cell goal) {
  Scenario scenario;
  scenario.id = "test";
  scenario.terrain = terrain_of(grid);
  scenario.start = start;
  scenario.goal = goal;
  return scenario;
}

std::string png(const Scenario& scenario, const Answer& answer, const std::string& title = "a title") {
  std::ostringstream out;
  write_png(out, scenario, {title, answer});
  return out.str();
}

/// A picture that can be asked for the colour of a map's cell.
class Picture {
 public:
  Picture(const Scenario& scenario, const Answer& answer)
      : layout_(layout_of(scenario.grid())), pixels_(png_pixels(png(scenario, answer))) {}

  Colour centre_of(Cell cell) const { return at({static_cast<double>(cell.x), static_cast<double>(cell.y)}); }
  // In cells; a cell's centre has the cell's coordinates.
  Colour at(Point point) const {
    return pixel(static_cast<int>(layout_.left + (point.x + 0.5) * layout_.scale),
                 static_cast<int>(layout_.head + (point.y + 0.5) * layout_.scale));
  }
  Colour pixel(int x, int y) const {
    const std::size_t i = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(pixels_.width) +
                               static_cast<std::size_t>(x));
    return {pixels_.bytes.at(i), pixels_.bytes.at(i + 1), pixels_.bytes.at(i + 2)};
  }
  const Pixels& pixels() const { return pixels_; }

 private:
  PictureLayout layout_;
  Pixels pixels_;
};

TEST(Png, AFileBeginsWithSignatureAndSize) {
  const testing::PngHeader header = png_header(png_bytes(Canvas(300, 7, palette.path)));
  EXPECT_TRUE(header.signature);
  EXPECT_TRUE(header.begins_with_header);
  EXPECT_EQ(header.width, 300U);
  EXPECT_EQ(header.height, 7U);
  EXPECT_EQ(header.bit_depth, 8);
  EXPECT_EQ(header.colour_type, 2);  // red, green, blue
  EXPECT_EQ(header.interlace, 0);
}

TEST(Png, AFileEndsWhereItsChunksEndAndTellsNoTime) {
  const std::vector<std::string> chunks = testing::png_chunks(png_bytes(Canvas(20, 20, palette.path)));
  EXPECT_EQ(chunks.back(), "IEND");
  for (const std::string& chunk : chunks) EXPECT_NE(chunk, "tIME");
}

TEST(Png, TheReaderSeesTheCanvas) {
  Canvas canvas(31, 17, palette.ground);
  canvas.fill_disc({12, 8}, 6, palette.goal);
  const Pixels pixels = png_pixels(png_bytes(canvas));
  EXPECT_EQ(pixels.width, 31);
  EXPECT_EQ(pixels.height, 17);
  EXPECT_EQ(pixels.bytes, canvas.bytes());
}

TEST(Png, WhatLibpngRefusesIsAnErrorInItsWords) {
  try {
    png_bytes(Canvas(1'000'001, 1, palette.paper));  // libpng's limit is a million a side
    FAIL() << "no error";
  } catch (const EnvironmentError& error) {
    EXPECT_NE(std::string(error.what()).find("1000001x1"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("IHDR"), std::string::npos) << error.what();
  }
}

TEST(PngPicture, ShowsObstaclesPathStartAndGoal) {
  const Scenario scenario = scenario_on(grid_of({".#..", ".#..", "...."}), {0, 0}, {3, 0});
  const Picture picture(scenario,
                        lattice_path({{0, 0}, {0, 1}, {0, 2}, {1, 2}, {2, 2}, {3, 2}, {3, 1}, {3, 0}}));
  EXPECT_EQ(picture.centre_of({1, 0}), palette.obstacle);
  EXPECT_EQ(picture.centre_of({1, 1}), palette.obstacle);
  EXPECT_EQ(picture.centre_of({2, 0}), palette.ground);
  EXPECT_EQ(picture.centre_of({0, 1}), palette.path);
  EXPECT_EQ(picture.centre_of({2, 2}), palette.path);
  EXPECT_EQ(picture.at({2.5, 2}), palette.path);
  EXPECT_EQ(picture.at({2, 1.7}), palette.ground);  // beside the line
  EXPECT_EQ(picture.centre_of({0, 0}), palette.start);
  EXPECT_EQ(picture.centre_of({3, 0}), palette.goal);
  EXPECT_EQ(picture.at({3.34, 0}), palette.goal);      // its ring
  EXPECT_EQ(picture.at({3.2, 0}), palette.paper);      // between ring and heart
  EXPECT_EQ(picture.at({-0.5, 1}), palette.obstacle);  // the frame
}

TEST(PngPicture, WithoutAnAnswerItShowsTheQuestion) {
  const Picture picture(scenario_on(grid_of({"...", "..."}), {0, 0}, {2, 0}), std::nullopt);
  EXPECT_EQ(picture.centre_of({1, 0}), palette.ground);
  EXPECT_EQ(picture.centre_of({0, 0}), palette.start);
}

TEST(PngPicture, StartAndGoalBothShowInOneCell) {
  const Picture picture(scenario_on(grid_of({"..", ".."}), {0, 0}, {0, 0}), std::nullopt);
  EXPECT_EQ(picture.centre_of({0, 0}), palette.start);
  EXPECT_EQ(picture.at({0.34, 0}), palette.goal);
}

TEST(PngPicture, HasATitleAndTheCaptionInItsHead) {
  const Picture titled(scenario_on(grid_of({".."}), {0, 0}, {1, 0}), std::nullopt);
  int ink = 0;
  int faint = 0;
  for (int y = 0; y < 55; ++y) {
    for (int x = 0; x < titled.pixels().width; ++x) {
      ink += titled.pixel(x, y) == palette.ink && y < 32 ? 1 : 0;
      faint += titled.pixel(x, y) == palette.faint && y >= 32 ? 1 : 0;
    }
  }
  EXPECT_GT(ink, 50);
  EXPECT_GT(faint, 50);
}

TEST(PngPicture, EqualArgumentsGiveEqualBytes) {
  const Scenario scenario = scenario_on(testing::random_grid(Stream(5), 60, 40, 0.3), {0, 0}, {59, 39});
  const Answer answer = Path{Track::any_angle, {{0, 0}, {20.3, 7.9}, {59, 39}}};
  EXPECT_EQ(png(scenario, answer), png(scenario, answer));
  EXPECT_NE(png(scenario, answer), png(scenario, std::nullopt));
}

TEST(PngPicture, HasTheSizeOfItsLayoutForAnyMap) {
  for (const auto& [width, height] :
       {std::pair(1, 1), std::pair(5, 5), std::pair(512, 512), std::pair(1, 3000), std::pair(4000, 7)}) {
    const Scenario scenario = scenario_on(OccupancyGrid(width, height), {0, 0}, {0, 0});
    const PictureLayout layout = layout_of(scenario.grid());
    const testing::PngHeader header = png_header(png(scenario, std::nullopt));
    SCOPED_TRACE(std::to_string(width) + "x" + std::to_string(height));
    EXPECT_EQ(header.width, layout.width);
    EXPECT_EQ(header.height, layout.height);
    EXPECT_LE(header.width, 1632U);
    EXPECT_LE(header.height, 1692U);
  }
}

TEST(PngPicture, ThinWallsOfALargeMapShowAsHalfTones) {
  OccupancyGrid grid(3200, 3200);
  for (int x = 0; x < 3200; ++x) {
    for (int y = 0; y < 3200; ++y) {
      if (x < 1600 || x % 2 == 0) grid.block({x, y});
    }
  }
  const Picture picture(scenario_on(grid, {3199, 0}, {3199, 1}), std::nullopt);
  Canvas half(1, 1, palette.ground);
  half.blend(0, 0, palette.obstacle, 128);
  EXPECT_EQ(picture.pixel(16 + 400, 56 + 800), palette.obstacle);  // two cells a pixel, both blocked
  EXPECT_EQ(picture.pixel(16 + 1200, 56 + 800), half.at(0, 0));    // one of two
}

TEST(PngPicture, SurvivesAnswersThatLeadAnywhere) {
  const Scenario scenario = scenario_on(grid_of({"..", ".."}), {0, 0}, {1, 1});
  const Path wild{Track::any_angle,
                  {{0, 0}, {1e300, -1e300}, {std::numeric_limits<double>::quiet_NaN(), 0}, {1, 1}}};
  EXPECT_TRUE(png_header(png(scenario, wild)).signature);
  EXPECT_TRUE(png_header(png(scenario, Path{}, std::string(5000, '&'))).signature);
  EXPECT_TRUE(png_header(png(scenario, std::nullopt, "")).signature);
}

}  // namespace
}  // namespace pathrace::results
