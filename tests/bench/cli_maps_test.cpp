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
  says({"--start-m", "9,9", "--goal", "3,0"}, "--start-m: expected a point on the map, got '9,9'");
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
