#include "core/names.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "core/catalogue.hpp"
#include "core/move_rule.hpp"
#include "core/path.hpp"
#include "core/record.hpp"

namespace pathrace {
namespace {

TEST(NearestName, HasTheLeastEditDistance) {
  EXPECT_EQ(nearest_name("asta", {"dijkstra", "astar", "as"}), "astar");
  EXPECT_EQ(nearest_name("dijkstar", {"dijkstra", "astar", "as"}), "dijkstra");
  EXPECT_EQ(nearest_name("", {"dijkstra", "as"}), "as");
  EXPECT_EQ(nearest_name("kitten", {"mitten-glove", "sitting", "flat-cat"}), "sitting");
}

TEST(NearestName, IsTheFirstOfEquals) {
  EXPECT_EQ(nearest_name("ac", {"ab", "aa"}), "ab");
}

TEST(NearestName, OfNothingIsEmpty) {
  EXPECT_EQ(nearest_name("anything", {}), "");
}

TEST(UnknownName, IsOneLineThatNamesTheNearestMatch) {
  EXPECT_EQ(unknown_name("planner", "asta", {"as", "astar"}),
            "unknown planner 'asta'; the nearest match is 'astar'");
  EXPECT_EQ(unknown_name("parameter", "ants", {}), "unknown parameter 'ants'; there are none");
}

template <typename Enum>
void expect_round_trip(std::size_t count) {
  const std::vector<std::string> names = all_names<Enum>();
  ASSERT_EQ(names.size(), count);
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), count);
  std::set<Enum> values;
  for (const std::string& text : names) {
    const Enum value = parse_name<Enum>("name", text);
    EXPECT_EQ(name(value), text);
    values.insert(value);
  }
  EXPECT_EQ(values.size(), count);
}

TEST(Names, EveryEnumReadsBackWhatItPrints) {
  expect_round_trip<MoveRule>(4);
  expect_round_trip<Track>(3);
  expect_round_trip<Verdict>(11);
  expect_round_trip<Kind>(8);
  expect_round_trip<Source>(7);
}

TEST(Names, AreThoseOfTheCommandLine) {
  EXPECT_EQ(name(MoveRule::four), "four");
  EXPECT_EQ(name(MoveRule::strict), "strict");
  EXPECT_EQ(name(MoveRule::squeeze), "squeeze");
  EXPECT_EQ(name(MoveRule::free), "free");
  EXPECT_EQ(name(Track::any_angle), "any_angle");
  EXPECT_EQ(name(Verdict::no_path), "no_path");
}

TEST(Names, AnUnknownSpellingNamesTheNearestMatch) {
  try {
    parse_name<MoveRule>("move rule", "strickt");
    ADD_FAILURE() << "accepted";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "unknown move rule 'strickt'; the nearest match is 'strict'");
  }
  EXPECT_THROW(parse_name<MoveRule>("move rule", "Strict"), InputError);
  EXPECT_THROW(parse_name<MoveRule>("move rule", ""), InputError);
}

TEST(Names, AValueOutsideTheEnumHasAPrintableName) {
  EXPECT_EQ(name(static_cast<MoveRule>(99)), "?");
}

}  // namespace
}  // namespace pathrace
