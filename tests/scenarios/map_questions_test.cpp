// Questions on a map file: ends in cells and in metres, help for bad ones, drawn questions, move rules.
#include "scenarios/map_questions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "core/error.hpp"
#include "scenarios/library.hpp"
#include "scenarios/under_rule.hpp"
#include "tests/scenarios/movingai_files.hpp"
#include "tests/support/oracle.hpp"

namespace pathrace::scenarios {
namespace {

using testing::message_of;
using testing::TemporaryFolder;

// One blocked cell at 3,2.
const char* const picture =
    "P2\n8 5\n255\n"
    "255 255 255 255 255 255 255 255\n255 255 255 255 255 255 255 255\n"
    "255 255 255 0 255 255 255 255\n"
    "255 255 255 255 255 255 255 255\n255 255 255 255 255 255 255 255\n";
const char* const yaml = "image: yard.pgm\nresolution: 0.5\norigin: [-1, -2, 0]\n";

class OnAMap : public ::testing::Test {
 protected:
  OnAMap() : pgm_(folder_.write("yard.pgm", picture)), yaml_(folder_.write("yard.yaml", yaml)) {}

  template <typename Place>
  std::string refusal(const MapQuestions& map, Place start) {
    return message_of<InputError>([&] { map.between(map.at(start), map.at(Cell{7, 4})); });
  }
  MapOptions with_radius(double radius) {
    MapOptions options;
    options.radius = radius;
    return options;
  }

  TemporaryFolder folder_;
  std::filesystem::path pgm_;
  std::filesystem::path yaml_;
};

TEST_F(OnAMap, APlaceInMetresIsTheCellThatHoldsIt) {
  const MapQuestions map(yaml_, {});
  // Lower left corner -1,-2; rows count from the top, so row 0 ends at y = -2 + 5 * 0.5.
  EXPECT_EQ(map.at(WorldPoint{-0.99, 0.49}).cell, (Cell{0, 0}));
  EXPECT_EQ(map.at(WorldPoint{0.8, -0.25}).cell, (Cell{3, 1}));
  EXPECT_DOUBLE_EQ(map.at(WorldPoint{0.8, -0.25}).point.x, 3.1);
  EXPECT_DOUBLE_EQ(map.at(WorldPoint{0.8, -0.25}).point.y, 1);
  const std::string off = message_of<InputError>([&] { map.at(WorldPoint{9, 9}); });
  EXPECT_NE(off.find("yard.yaml: 9 m, 9 m is no point on the map, which is 4 m wide and 2.5 m high, with its "
                     "lower left corner at -1,-2"),
            std::string::npos)
      << off;
}

TEST_F(OnAMap, AnEndInAnObstacleIsToldTheNearestFreeCell) {
  // A radius of 0.5 m is one cell: the eight cells around the obstacle are too near.
  const MapQuestions grown(yaml_, with_radius(0.5));
  EXPECT_EQ(
      refusal(grown, Cell{3, 1}),
      yaml_.string() + ": start 3,1 lies in a grown obstacle; the nearest free cell, 3,0, is 0.50 m away");
  // 0.1 cells to the side: sqrt(1 + 0.01) cells of 0.5 m.
  EXPECT_EQ(refusal(grown, WorldPoint{0.8, -0.25}),
            yaml_.string() +
                ": start 0.8 m, -0.25 m (cell 3,1) lies in a grown obstacle; the nearest free cell, 3,0, is "
                "0.50 m away");
  EXPECT_EQ(refusal(MapQuestions(yaml_, {}), Cell{3, 2}),
            yaml_.string() + ": start 3,2 is a blocked cell; the nearest free cell, 3,1, is 0.50 m away");
  EXPECT_EQ(refusal(MapQuestions(pgm_, {}), Cell{3, 2}),
            pgm_.string() + ": start 3,2 is a blocked cell; the nearest free cell, 3,1, is 1.0 cells away");
  EXPECT_NE(refusal(MapQuestions(pgm_, {}), Cell{8, 0}).find("start 8,0 is outside the 8x5 map"),
            std::string::npos);
  EXPECT_NE(refusal(MapQuestions(pgm_, with_radius(20)), Cell{0, 0}).find("the map has no free cell"),
            std::string::npos);
}

TEST_F(OnAMap, AnIdSaysWhatMadeTheGrid) {
  const auto id = [&](const MapQuestions& map) {
    return map.between(map.at(Cell{0, 0}), map.at(Cell{7, 4})).id;
  };
  EXPECT_EQ(id(MapQuestions(yaml_, {})), "map/yard/0,0/7,4");
  EXPECT_EQ(id(MapQuestions(yaml_, with_radius(0.25))), "map/yard,radius=0.25/0,0/7,4");
  MapOptions options;
  options.unknown = UnknownPolicy::free;
  options.resolution = 0.1;
  EXPECT_EQ(id(MapQuestions(pgm_, options, "hall")), "map/hall,resolution=0.1,unknown=free/0,0/7,4");
}

TEST_F(OnAMap, DrawnQuestionsAreFarApartDifferentAndProven) {
  const MapQuestions map(yaml_, with_radius(0.5));
  for (const MoveRule rule : {MoveRule::strict, MoveRule::four, MoveRule::free}) {
    const std::vector<Scenario> drawn = map.draw(6, 1, rule);
    ASSERT_EQ(drawn.size(), 6U);
    std::set<std::string> ids;
    for (const Scenario& scenario : drawn) {
      ids.insert(scenario.id);
      EXPECT_EQ(scenario.terrain.rule, rule);
      const auto length = [&](Cell goal) {
        const auto optimum = testing::oracle_optimum(scenario.grid(), rule, scenario.start, goal);
        return optimum ? optimum->value() : 0;
      };
      double greatest = 0;
      for (int y = 0; y < 5; ++y) {
        for (int x = 0; x < 8; ++x) {
          if (scenario.grid().is_free({x, y})) greatest = std::max(greatest, length({x, y}));
        }
      }
      EXPECT_GE(length(scenario.goal), greatest / 2) << scenario.id;
      ASSERT_TRUE(scenario.optimum.proven && scenario.optimum.length) << scenario.id;
      EXPECT_EQ(scenario.optimum.length->value(), length(scenario.goal)) << scenario.id;
    }
    EXPECT_EQ(ids.size(), 6U);
    EXPECT_EQ(map.draw(6, 1, rule).back().id, drawn.back().id);
    EXPECT_NE(map.draw(1, 2, rule).front().id + map.draw(2, 2, rule).back().id,
              drawn[0].id + drawn[1].id);  // another seed
  }
}

TEST_F(OnAMap, ATinyMapHasFewQuestions) {
  EXPECT_EQ(MapQuestions(folder_.write("two.txt", "00\n"), {}).draw(9, 1, MoveRule::strict).size(), 2U);
  const MapQuestions one(folder_.write("one.txt", "01\n"), {});
  EXPECT_NE(
      message_of<InvalidScenario>([&] { one.draw(1, 1, MoveRule::strict); }).find("1 free cells; expected 2"),
      std::string::npos);
}

TEST(UnderRule, AnotherRuleIsAnotherQuestionWithItsOwnId) {
  const Library library;
  const Scenario own = library.load("asr/fig5");
  const Scenario free = library.load("asr/fig5,rule=free");
  EXPECT_EQ(free.id, "asr/fig5,rule=free");
  EXPECT_EQ(free.terrain.rule, MoveRule::free);
  EXPECT_FALSE(free.optimum.proven);
  EXPECT_NE(content_hash(free), content_hash(own));
  EXPECT_EQ(library.load("asr/fig5,rule=strict").id, "asr/fig5");
  EXPECT_EQ(under_rule(own, MoveRule::strict).optimum.proven, own.optimum.proven);
  EXPECT_NE(message_of<InputError>([&] { library.load("asr/fig5,rule=fre"); }).find("'free'"),
            std::string::npos);
  EXPECT_NE(message_of<InputError>([&] { library.load("discs/open/1,rule=free"); }).find("dynamic world"),
            std::string::npos);
}

}  // namespace
}  // namespace pathrace::scenarios
