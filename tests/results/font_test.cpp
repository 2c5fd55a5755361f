#include "results/font.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>

namespace pathrace::results {
namespace {

// The letter as pixels, ten to the font's unit.
std::vector<std::uint8_t> drawn(const std::string& letter) {
  Canvas canvas(60, 100, {255, 255, 255});
  Lettering letters = lettering(letter);
  for (Segment& stroke : letters.strokes) {
    stroke.from = {5 + 10 * stroke.from.x, 5 + 10 * stroke.from.y};
    stroke.to = {5 + 10 * stroke.to.x, 5 + 10 * stroke.to.y};
  }
  canvas.stroke(letters.strokes, 8, {0, 0, 0});
  return canvas.bytes();
}

TEST(Font, EachGlyphDiffersFromAllOthers) {
  std::map<std::vector<std::uint8_t>, std::string> seen;
  std::vector<std::string> letters = {"\u00b7", "\u00d7", "\u2026", "\u20ac"};
  for (char c = 0x20; c < 0x7F; ++c) letters.emplace_back(1, c);
  for (const std::string& letter : letters) {
    const auto [other, fresh] = seen.emplace(drawn(letter), letter);
    EXPECT_TRUE(fresh) << "'" << letter << "' looks like '" << other->second << "'";
  }
  EXPECT_EQ(seen.size(), 99U);
}

TEST(Font, OnlyTheBlankIsBlank) {
  EXPECT_TRUE(lettering(" ").strokes.empty());
  for (char c = 0x21; c < 0x7F; ++c) EXPECT_FALSE(lettering(std::string(1, c)).strokes.empty()) << c;
}

TEST(Font, StaysInItsBoxOfFiveByNine) {
  for (char c = 0x20; c < 0x7F; ++c) {
    const Lettering letters = lettering(std::string(1, c));
    EXPECT_LE(letters.width, 5) << c;
    for (const Segment& stroke : letters.strokes) {
      for (const Point point : {stroke.from, stroke.to}) {
        EXPECT_TRUE(point.x >= 0 && point.x < letters.width && point.y >= 0 && point.y < 9) << c;
      }
    }
  }
}

TEST(Font, OneEmptyColumnLiesBetweenLetters) {
  EXPECT_EQ(lettering("i").width, 1);
  EXPECT_EQ(lettering("W").width, 5);
  EXPECT_EQ(lettering("iWi").width, 1 + 1 + 5 + 1 + 1);
  EXPECT_EQ(lettering("").width, 0);
}

TEST(Font, CapitalsAndFiguresStandOnTheBaseline) {
  for (const char c : std::string("ABCDEFGHIJKLMNOPRSTUVWXYZ0123456789")) {
    double upper = 9;
    double lower = 0;
    for (const Segment& stroke : lettering(std::string(1, c)).strokes) {
      upper = std::min({upper, stroke.from.y, stroke.to.y});
      lower = std::max({lower, stroke.from.y, stroke.to.y});
    }
    EXPECT_EQ(upper, 0) << c;
    EXPECT_EQ(lower, 6) << c;
  }
}

TEST(Font, DotsOfALetterAreJoined) {
  // An L is six steps down and three to the right, nine lines of length 1.
  EXPECT_EQ(lettering("L").strokes.size(), 9U);
  // A dot has no neighbour: a line from itself to itself.
  const Lettering dot = lettering(".");
  ASSERT_EQ(dot.strokes.size(), 1U);
  EXPECT_EQ(dot.strokes[0].from, dot.strokes[0].to);
}

TEST(Font, WhatItDoesNotKnowIsABox) {
  const std::vector<std::uint8_t> box = drawn("\u20ac");
  EXPECT_EQ(drawn("\x01"), box);
  EXPECT_EQ(drawn("\x7F"), box);
  EXPECT_EQ(drawn("\xFF"), box);
  EXPECT_EQ(drawn("\u00e9"), box);
  EXPECT_EQ(lettering("\xFF\xFF").width, 11);
}

}  // namespace
}  // namespace pathrace::results
