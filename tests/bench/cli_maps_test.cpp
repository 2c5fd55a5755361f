// Map files of every kind on the command line.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/bench/command_line.hpp"

namespace pathrace::bench {
namespace {

using testing::Finished;
using testing::ScratchFolder;
using Json = nlohmann::json;

// Half a metre a cell; the wall leaves the lowest row open, where one cell is unknown.
const char* const picture = "P2\n4 3\n255\n255 0 255 255\n255 0 255 255\n255 205 255 255\n";
const char* const yaml = "image: room.pgm\nresolution: 0.5\norigin: [-1, -2, 0]\n";

TEST(MapFiles, PlanFindsTheSameWayInCellsAndInMetres) {
  const ScratchFolder scratch;
  scratch.file("room.pgm", picture);
  const std::string map = scratch.file("room.yaml", yaml);
  const Finished cells = pathrace({"plan", "--map", map, "--unknown", "free", "--start", "0,0", "--goal",
                                   "3,0", "--planner", "astar", "--json"});
  ASSERT_EQ(cells.exit_code, 0) << cells.err;
  // Two down, two along, and up on the right: one step there is a diagonal, none may touch the wall.
  EXPECT_NEAR(Json::parse(cells.out)["length"].get<double>(), 5 + std::sqrt(2.0), 1e-9);
  const Finished metres = pathrace({"plan", "--map", map, "--unknown", "free", "--start-m=-0.75,-0.75",
                                    "--goal-m", "0.75,-0.75", "--planner", "astar", "--json"});
  ASSERT_EQ(metres.exit_code, 0) << metres.err;
  EXPECT_EQ(Json::parse(metres.out)["cells"], Json::parse(cells.out)["cells"]);
  const Finished blocked =
      pathrace({"plan", "--map", map, "--start", "0,0", "--goal", "3,0", "--planner", "astar", "--json"});
  EXPECT_EQ(Json::parse(blocked.out)["verdict"], "no_path");
  const Finished grown = pathrace({"plan", "--map", map, "--unknown", "free", "--radius", "0.5", "--start",
                                   "3,0", "--goal", "3,2", "--planner", "astar", "--json"});
  EXPECT_EQ(Json::parse(grown.out)["length"], 2.0) << grown.err;
}

TEST(MapFiles, AQuestionInMetresIsAnsweredInMetres) {
  const ScratchFolder scratch;
  scratch.file("room.pgm", picture);
  const std::string map = scratch.file("room.yaml", yaml);
  const std::vector<std::string> question = {
      "plan",     "--map",      map,         "--unknown", "free", "--start-m=-0.8,-0.75",
      "--goal-m", "0.75,-0.75", "--planner", "astar"};
  const auto with = [&](const std::string& option) {
    std::vector<std::string> arguments = question;
    arguments.push_back(option);
    return pathrace(arguments);
  };
  const Json json = Json::parse(with("--json").out);
  // 5 + sqrt 2 edges of half a metre; the cells' centres lie a quarter of a metre inside.
  EXPECT_NEAR(json["length_m"].get<double>(), (5 + std::sqrt(2.0)) / 2, 1e-9);
  EXPECT_EQ(json["start_m"], Json({-0.75, -0.75}));
  EXPECT_EQ(json["goal_m"], Json({0.75, -0.75}));
  ASSERT_EQ(json["points_m"].size(), json["cells"].size());
  EXPECT_EQ(json["points_m"].front(), json["start_m"]);
  EXPECT_EQ(json["points_m"].back(), json["goal_m"]);
  const std::string text = with("--threads=1").out;
  EXPECT_NE(text.find("length       3.2071 m (6.4142 cells)   optimum 3.2071 m"), std::string::npos) << text;
  EXPECT_NE(text.find("start        -0.750,-0.750 m"), std::string::npos) << text;
  EXPECT_NE(text.find("way, m       -0.750,-0.750"), std::string::npos) << text;
}

TEST(MapFiles, WithoutAFrameThereAreNoMetres) {
  const ScratchFolder scratch;
  const std::string map = scratch.file("x.txt", "000\n");
  const auto plan = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"plan",   "--map", map,         "--start", "0,0",
                                          "--goal", "2,0",   "--planner", "astar",   "--json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return Json::parse(pathrace(arguments).out);
  };
  for (const char* key : {"length_m", "start_m", "goal_m", "points_m"})
    EXPECT_TRUE(plan({}).at(key).is_null()) << key;
  EXPECT_EQ(plan({"--resolution", "0.5"})["length_m"], 1.0);
  const Json far =
      Json::parse(pathrace({"plan", "--scenario", "asr/fig5", "--planner", "astar", "--json"}).out);
  EXPECT_TRUE(far.at("points_m").is_null());
}

TEST(MapFiles, PlanRefusesEndsThatAreNone) {
  const ScratchFolder scratch;
  scratch.file("room.pgm", picture);
  const std::string map = scratch.file("room.yaml", yaml);
  const auto says = [&](const std::vector<std::string>& ends, const std::string& words) {
    std::vector<std::string> arguments = {"plan", "--map", map, "--planner", "astar"};
    arguments.insert(arguments.end(), ends.begin(), ends.end());
    const Finished finished = pathrace(arguments);
    EXPECT_EQ(finished.exit_code, 2);
    EXPECT_NE(finished.err.find(words), std::string::npos) << finished.err;
    EXPECT_EQ(std::count(finished.err.begin(), finished.err.end(), '\n'), 1) << finished.err;
  };
  says({}, "--map needs either --start X,Y or --start-m X,Y");
  says({"--start", "0,0", "--start-m", "0,0", "--goal", "3,0"}, "either --start X,Y or --start-m X,Y");
  says({"--start-m", "9,9", "--goal", "3,0"}, "9 m, 9 m is no point on the map, which is 2 m wide");
  says({"--start-m", "9;9", "--goal", "3,0"}, "got '9;9'");
  says({"--start", "0,0", "--goal", "3,0", "--unknown", "fre"}, "'free'");
  says({"--start", "0,0", "--goal", "3,0", "--resolution", "1"}, "says its resolution itself");
}

TEST(MapFiles, CheckTellsWhatAMapIs) {
  const ScratchFolder scratch;
  const std::string pgm = scratch.file("room.pgm", picture);
  const std::string map = scratch.file("room.yaml", yaml);
  EXPECT_EQ(pathrace({"scenarios", "check", map}).out,
            map +
                ": a map of 4x3 cells, 9 free, 1 unknown (taken as blocked), resolution 0.5, origin -1,-2, "
                "yaw 0\n");
  EXPECT_EQ(
      pathrace({"scenarios", "check", pgm, "--unknown", "free", "--resolution", "2"}).out,
      pgm + ": a map of 4x3 cells, 10 free, 1 unknown (taken as free), resolution 2, origin 0,0, yaw 0\n");
  const Finished bad = pathrace({"scenarios", "check", scratch.file("bad.csv", "0,2\n")});
  EXPECT_EQ(bad.exit_code, 2);
  EXPECT_NE(bad.err.find("bad.csv:1: '2' in column 3"), std::string::npos) << bad.err;
  EXPECT_NE(pathrace({"scenarios", "check", "x.jpeg"}).err.find(".yaml"), std::string::npos);
}

TEST(MapFiles, EveryExportIsReadAgain) {
  const ScratchFolder scratch;
  for (const std::string format : {"map", "png", "csv", "txt"}) {
    const std::string file = scratch / ("fig5." + format);
    ASSERT_EQ(pathrace({"scenarios", "export", "asr/fig5", "--format", format, "-o", file}).exit_code, 0);
    // asr/fig5 is 5x5 with two blocked cells.
    EXPECT_NE(pathrace({"scenarios", "check", file}).out.find("a map of 5x5 cells, 23 free"),
              std::string::npos)
        << format;
  }
}

TEST(MapFiles, AMapIsShownAndExportedIntoEveryFormatAndBack) {
  const ScratchFolder scratch;
  scratch.file("room.pgm", picture);
  const std::string map = scratch.file("room.yaml", yaml);
  const Finished shown = pathrace({"scenarios", "show", map});
  EXPECT_NE(shown.out.find("a map of 4x3 cells, 9 free"), std::string::npos) << shown.out << shown.err;
  EXPECT_NE(shown.out.find("\n.#..\n.#..\n.#..\n"), std::string::npos) << shown.out;
  const std::string movingai = "type octile\nheight 3\nwidth 4\nmap\n.@..\n.@..\n.@..\n";
  EXPECT_EQ(pathrace({"scenarios", "export", map, "--format", "map"}).out, movingai);
  const std::string as_map = scratch.file("again.map", movingai);
  ASSERT_EQ(pathrace({"scenarios", "export", as_map, "--format", "ros", "--resolution", "0.5", "-o",
                      scratch / "back.yaml"})
                .exit_code,
            0);
  EXPECT_EQ(pathrace({"scenarios", "check", scratch / "back.yaml"}).out,
            (scratch / "back.yaml") +
                ": a map of 4x3 cells, 9 free, 0 unknown (taken as blocked), resolution 0.5, "
                "origin 0,0, yaw 0\n");
  EXPECT_EQ(pathrace({"scenarios", "export", scratch / "back.yaml", "--format", "map"}).out, movingai);
  ASSERT_EQ(pathrace({"scenarios", "export", map, "--format", "ros", "-o", scratch / "it's.yaml"}).exit_code,
            0);
  EXPECT_NE(
      pathrace({"scenarios", "check", scratch / "it's.yaml"}).out.find("resolution 0.5, origin -1,-2, yaw 0"),
      std::string::npos);
  EXPECT_EQ(pathrace({"scenarios", "show", map, "-o", scratch / "room.png"}).exit_code, 0);
  EXPECT_NE(pathrace({"scenarios", "check", scratch / "room.png"}).out.find("4x3 cells, 9 free"),
            std::string::npos);
}

TEST(MapFiles, ExportsThatCannotBeAreRefused) {
  const ScratchFolder scratch;
  scratch.file("room.pgm", picture);
  const std::string map = scratch.file("room.yaml", yaml);
  expect_refusal(pathrace({"scenarios", "export", map, "--format", "scen"}),
                 {"room.yaml", "without start and goal"});
  expect_refusal(pathrace({"scenarios", "export", map, "--format", "mapp"}), {"'map'"});
  expect_refusal(pathrace({"scenarios", "export", map, "--format", "ros"}), {"-o FILE.yaml"});
  expect_refusal(pathrace({"scenarios", "export", map, "--format", "ros", "-o", map}), {"is the map itself"});
}

TEST(MapFiles, AScenIsCheckedWithTheMapsBesideItOrInAGivenFolder) {
  const ScratchFolder scratch;
  for (const char* folder : {"dao-map", "dao-scen", "maps"})
    std::filesystem::create_directory(scratch.path() / folder);
  scratch.file("dao-map/small.map", small_map);
  const std::string query = "version 1\n0\tsmall.map\t4\t3\t0\t0\t3\t0\t3\n";
  const std::string scen = scratch.file("dao-scen/small.map.scen", query);
  EXPECT_EQ(pathrace({"scenarios", "check", scen}).out, scen + ": 1 queries on small.map, 0 bad\n");
  std::filesystem::rename(scratch.path() / "dao-map/small.map", scratch.path() / "maps/small.map");
  expect_refusal(pathrace({"scenarios", "check", scen}), {"names map 'small.map'"});
  EXPECT_EQ(pathrace({"scenarios", "check", scen, "--maps", scratch / "maps"}).exit_code, 0);
}

TEST(MapFiles, TheLibraryAsksQuestionsOnRosMaps) {
  const ScratchFolder scratch;
  scratch.file("room.pgm", picture);
  scratch.file("room.yaml", yaml);
  const Finished plan = pathrace({"plan", "--scenario", "ros/room/3", "--maps", scratch.path().string(),
                                  "--planner", "astar", "--json"});
  ASSERT_EQ(plan.exit_code, 0) << plan.err;
  EXPECT_EQ(Json::parse(plan.out)["verdict"], "solved");
}

}  // namespace
}  // namespace pathrace::bench
