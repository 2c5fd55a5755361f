// From ids and patterns to scenarios.
#include "scenarios/library.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "core/error.hpp"
#include "scenarios/ascii.hpp"
#include "tests/support/maps.hpp"

namespace pathrace::scenarios {
namespace {

std::string error_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Library, ARangeStandsForItsSeeds) {
  const Library library;
  EXPECT_EQ(library.select("dense/20-20/9..11"),
            (std::vector<std::string>{"dense/20-20/9", "dense/20-20/10", "dense/20-20/11"}));
  EXPECT_EQ(library.select("dense/37-15/123456"), std::vector<std::string>{"dense/37-15/123456"});
}

TEST(Library, AGlobStaysWithinThePartsOfAnId) {
  const Library library;
  EXPECT_EQ(library.select("trap-*/20/*").size(), 300U);
  EXPECT_EQ(library.select("asr/*").size(), 3U);
  EXPECT_EQ(library.select("trap-*/20/1..2").size(), 20U);
  EXPECT_NE(error_of([&] { library.select("trap-*"); }).find("matches nothing"), std::string::npos);
}

TEST(Library, RangesThatAreNoneAreRefused) {
  const Library library;
  for (const char* pattern :
       {"dense/20-20/5..1", "dense/20-20/..5", "dense/20-20/5..", "dense/20-20/1..9999999999"}) {
    EXPECT_NE(error_of([&] { library.select(pattern); }).find("FIRST..LAST"), std::string::npos) << pattern;
  }
}

TEST(Library, AnUnknownFamilyIsNamedWithItsNearestMatch) {
  const Library library;
  EXPECT_NE(error_of([&] { library.load("dence/20-20/1"); }).find("'dense'"), std::string::npos);
  EXPECT_NE(error_of([&] { library.load("asr/fig3"); }).find("'fig2'"), std::string::npos);
}

TEST(Library, RecordedQueriesNeedAFolder) {
  const Library library;
  EXPECT_NE(error_of([&] { library.load("movingai/arena/1"); }).find("--maps"), std::string::npos);
}

TEST(Ascii, DrawsStartGoalAndObstacles) {
  Scenario scenario;
  scenario.terrain = testing::terrain_of(testing::grid_of({"..#", "#..", "..."}));
  scenario.start = {0, 0};
  scenario.goal = {2, 2};
  std::ostringstream out;
  print_ascii(out, scenario);
  EXPECT_EQ(out.str(), "S.#\n#..\n..G\n");
}

TEST(Ascii, DrawsLargeMapsInBlocks) {
  Scenario scenario;
  scenario.terrain = testing::terrain_of(OccupancyGrid(241, 10));
  scenario.start = {0, 0};
  scenario.goal = {240, 9};
  std::ostringstream out;
  print_ascii(out, scenario);
  const std::string text = out.str();
  EXPECT_EQ(text.find('\n'), 81U);  // 241 columns in blocks of three
}

}  // namespace
}  // namespace pathrace::scenarios
