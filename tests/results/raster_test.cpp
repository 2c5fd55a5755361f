#include "results/raster.hpp"

#include <gtest/gtest.h>

namespace pathrace::results {
namespace {

constexpr Colour white{255, 255, 255};
constexpr Colour black{0, 0, 0};
constexpr Colour red{200, 0, 0};

TEST(Canvas, BeginsInOneColour) {
  const Canvas canvas(3, 2, red);
  EXPECT_EQ(canvas.bytes().size(), 3U * 2U * 3U);
  for (int y = 0; y < 2; ++y) {
    for (int x = 0; x < 3; ++x) EXPECT_EQ(canvas.at(x, y), red);
  }
}

TEST(Canvas, ARectangleIsSharpAndCutAtTheEdges) {
  Canvas canvas(6, 6, white);
  canvas.fill_rectangle(-2, 1, 5, 2, black);
  for (int y = 0; y < 6; ++y) {
    for (int x = 0; x < 6; ++x) {
      const bool inside = x < 3 && y >= 1 && y < 3;
      EXPECT_EQ(canvas.at(x, y), inside ? black : white) << x << "," << y;
    }
  }
}

TEST(Canvas, HalfCoverageMixesTheColours) {
  Canvas canvas(1, 1, white);
  canvas.blend(0, 0, {155, 0, 255}, 51);  // a fifth: 255 - 0.2 * 100, 255 - 0.2 * 255, 255
  EXPECT_EQ(canvas.at(0, 0), (Colour{235, 204, 255}));
}

TEST(Canvas, ADiscCoversItsArea) {
  Canvas canvas(40, 40, white);
  canvas.fill_disc({20, 20}, 12, black);
  double covered = 0;
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 40; ++x) covered += (255 - canvas.at(x, y).red) / 255.0;
  }
  EXPECT_NEAR(covered, 3.14159 * 12 * 12, 2);
  EXPECT_EQ(canvas.at(20, 20), black);
  EXPECT_EQ(canvas.at(20, 9), black);   // 10.5 from the centre
  EXPECT_EQ(canvas.at(20, 6), white);   // 13.5 from it
  EXPECT_EQ(canvas.at(29, 29), white);  // 9.5 in each direction: 13.4
}

TEST(Canvas, ARingIsHollow) {
  Canvas canvas(41, 41, white);
  canvas.draw_ring({20.5, 20.5}, 15, 4, black);
  EXPECT_EQ(canvas.at(20, 20), white);
  EXPECT_EQ(canvas.at(20, 8), white);  // 12 from the centre
  EXPECT_EQ(canvas.at(20, 5), black);  // 15
  EXPECT_EQ(canvas.at(20, 2), white);  // 18
}

TEST(Canvas, AThickLineIsAsWideAsAskedAndRoundAtItsEnds) {
  Canvas canvas(40, 20, white);
  canvas.stroke({{{10, 10}, {30, 10}}}, 6, black);
  for (int y = 0; y < 20; ++y) EXPECT_EQ(canvas.at(20, y), y >= 7 && y < 13 ? black : white) << y;
  EXPECT_EQ(canvas.at(8, 9), black);   // 1.6 from the end
  EXPECT_EQ(canvas.at(7, 7), white);   // 3.5 from it, though within the square
  EXPECT_EQ(canvas.at(6, 10), white);  // 3.5 from it
}

TEST(Canvas, ADiagonalLineHasSoftEdges) {
  Canvas canvas(20, 20, white);
  canvas.stroke({{{2, 4}, {18, 15}}}, 3, black);
  int soft = 0;
  for (int y = 0; y < 20; ++y) {
    for (int x = 0; x < 20; ++x) soft += canvas.at(x, y) != black && canvas.at(x, y) != white ? 1 : 0;
  }
  EXPECT_GE(soft, 20);
}

TEST(Canvas, SegmentsThatOverlapArePaintedOnce) {
  Canvas once(20, 20, white);
  Canvas twice(20, 20, white);
  const Segment line{{3, 3}, {17, 12}};
  once.stroke({line}, 2, black);
  twice.stroke({line, line}, 2, black);
  EXPECT_EQ(once.bytes(), twice.bytes());
}

TEST(Canvas, WhatLiesOutsideIsLeftOut) {
  Canvas canvas(8, 8, white);
  canvas.fill_disc({-100, 4}, 20, black);
  canvas.draw_ring({4, 1000}, 20, 3, black);
  canvas.stroke({{{-1e6, -5}, {1e6, -5}}}, 2, black);
  canvas.stroke({}, 2, black);
  EXPECT_EQ(canvas.bytes(), Canvas(8, 8, white).bytes());
}

}  // namespace
}  // namespace pathrace::results
