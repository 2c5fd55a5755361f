// From ids and patterns to scenarios.
#include "scenarios/library.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <map>
#include <set>
#include <sstream>

#include "core/error.hpp"
#include "scenarios/ascii.hpp"
#include "scenarios/repeats.hpp"
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

TEST(Library, AGlobTakesASeedAsGivenListedOrNot) {
  const Library library;
  const std::vector<std::string> ids = library.select("trap-*/20/101");
  EXPECT_EQ(ids.size(), 10U);
  for (const std::string& id : ids) {
    EXPECT_TRUE(id.ends_with("/20/101")) << id;
    EXPECT_EQ(library.load(id).id, id);
  }
  EXPECT_EQ(library.select("trap-*/20/100..101").size(), 20U);
  EXPECT_EQ(library.select("trap-u/*/31"), (std::vector<std::string>{"trap-u/10/31", "trap-u/20/31"}));
  EXPECT_NE(error_of([&] { library.select("trap-*/21/1"); }).find("matches nothing"), std::string::npos);
  EXPECT_NE(error_of([&] { library.select("*/1"); }).find("matches nothing"), std::string::npos);
  const std::string unreadable = error_of([&] { library.load(library.select("trap-*/20/007").front()); });
  EXPECT_NE(unreadable.find("007"), std::string::npos) << unreadable;
}

TEST(Library, ThatOnePartOfARangeMatchesDoesNotHideThatAnotherDoesNot) {
  const Library library;
  EXPECT_NE(error_of([&] { library.select("trap-*/20..21/*"); }).find("'trap-*/21/*'"), std::string::npos);
}

TEST(Library, ListsNoQuestionTwice) {
  const Library library;
  std::map<std::uint64_t, std::string> first;
  for (const std::string& id : library.list()) {
    const auto [known, is_new] = first.emplace(content_hash(library.load(id)), id);
    EXPECT_TRUE(is_new) << id << " asks the question of " << known->second << ": a line for repeats.def";
  }
}

TEST(Library, LeavesOutOnlyIdsThatAskTheQuestionOfAListedOne) {
  const Library library;
  const std::vector<std::string> ids = library.list();
  const std::set<std::string> listed(ids.begin(), ids.end());
  for (const Repeat& repeat : repeats()) {
    const std::string id(repeat.id);
    const std::string earlier(repeat.earlier);
    EXPECT_FALSE(listed.contains(id)) << id;
    EXPECT_TRUE(listed.contains(earlier)) << earlier;
    EXPECT_EQ(content_hash(library.load(id)), content_hash(library.load(earlier)))
        << id << " and " << earlier;
  }
  EXPECT_EQ(ids.size() + repeats().size(), 1392U);  // 46 times 30 seeds, nine curated, three of asr
}

TEST(Library, GlobsLeaveOutRepeatsAndRangesKeepThem) {
  const Library library;
  EXPECT_EQ(library.select("trap-comb/10/*").size(), 28U);
  EXPECT_EQ(library.select("trap-comb/10/1..30").size(), 30U);
  EXPECT_EQ(library.select("trap-comb/10/21"), std::vector<std::string>{"trap-comb/10/21"});
}

TEST(Library, RangesThatAreNoneAreRefused) {
  const Library library;
  for (const char* pattern :
       {"dense/20-20/5..1", "dense/20-20/..5", "dense/20-20/5..", "dense/20-20/1..9999999999"}) {
    EXPECT_NE(error_of([&] { library.select(pattern); }).find("FIRST..LAST"), std::string::npos) << pattern;
  }
}

TEST(Library, PatternsThatStandForTooMuchAreRefusedBeforeTheyAreSpelt) {
  const Library library;
  EXPECT_NE(error_of([&] { library.select("dense/1..1000000/1..1000000"); }).find("at most a million"),
            std::string::npos);
  EXPECT_NE(error_of([&] { library.select("dense/*/1..2000000000"); }).find("at most a million"),
            std::string::npos);
  EXPECT_NE(
      error_of([&] { library.select("dense/*/1..100000"); }).find("100000 patterns; expected at most 10000"),
      std::string::npos);
  std::string ranges;
  for (int i = 0; i < 100'000; ++i) ranges += "1..1/";
  EXPECT_NE(error_of([&] { library.select(ranges); }).find("500000 bytes; expected at most 1000"),
            std::string::npos);
  EXPECT_EQ(library.select("dense/1..1000/1..1000").size(), 1'000'000U);
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
