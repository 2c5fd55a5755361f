// Grids of 0 and 1.
#include "scenarios/text_grid.hpp"

#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "tests/support/maps.hpp"

namespace pathrace::scenarios {
namespace {

TEST(TextGrid, EverySeparatorAndLineEndGivesTheSameGrid) {
  const OccupancyGrid expected = testing::grid_of({"01", "10", "11"});
  for (const std::string text :
       {"01\n10\n11\n", "01\n10\n11", "0,1\n1,0\n1,1\n", "0;1\n1;0\n1;1", "0 1\n1 0\n1 1\n",
        "0\t1\n1\t0\n1\t1\n", "0, 1\r\n1, 0\r\n1, 1\r\n", " 0  1 \n 1  0\n1 ; 1\n\n\n",
        "\xef\xbb\xbf"
        "0,1\n1,0\n1,1"}) {
    EXPECT_EQ(parse_text_grid(text, "x"), expected) << text;
  }
}

TEST(TextGrid, WhatSpreadsheetsAndNumpyWriteIsRead) {
  const OccupancyGrid expected = testing::grid_of({"010", "100"});
  for (const std::string text :
       {"\"0\",\"1\",\"0\"\n\"1\",\"0\",\"0\"\n", "0,1,0,\n1,0,0,\n", "0, 1, 0, \n1, 0, 0\n",
        "0.0 1.0 0.0\n1.0 0.0 0.0\n",
        "0.000000000000000000e+00,1.000000000000000000e+00,0.000000000000000000e+00\r\n"
        "1.000000000000000000e+00,0.000000000000000000e+00,-0.0\r\n",
        "0,1,0\r1,0,0\r"}) {
    EXPECT_EQ(parse_text_grid(text, "x"), expected) << text;
  }
  EXPECT_EQ(parse_text_grid("0.0e+00\n1.0e+00\n", "x"), testing::grid_of({"0", "1"}));
  EXPECT_EQ(parse_text_grid("10\n01\n", "x"), testing::grid_of({"10", "01"}));
}

TEST(TextGrid, OneCellIsAGrid) {
  EXPECT_EQ(parse_text_grid("0", "x"), OccupancyGrid(1, 1));
}

TEST(TextGrid, IsWrittenAsDigitsAndAsCommaSeparatedValues) {
  const OccupancyGrid grid = testing::grid_of({".#.", "##."});
  std::ostringstream txt;
  write_text_grid(txt, grid, "");
  EXPECT_EQ(txt.str(), "010\n110\n");
  std::ostringstream csv;
  write_text_grid(csv, grid, ",");
  EXPECT_EQ(csv.str(), "0,1,0\n1,1,0\n");
}

TEST(TextGrid, EveryRandomGridIsReadBack) {
  for (std::uint64_t i = 0; i < 100; ++i) {
    Stream stream = Stream(4).fork(i);
    const int width = stream.between(1, 40);
    const OccupancyGrid grid = testing::random_grid(stream.fork(0), width, stream.between(1, 40), 0.4);
    for (const char* separator : {"", ",", ";", " ", "\t"}) {
      std::ostringstream out;
      write_text_grid(out, grid, separator);
      ASSERT_EQ(parse_text_grid(out.str(), "x"), grid) << "map " << i;
    }
  }
}

}  // namespace
}  // namespace pathrace::scenarios
