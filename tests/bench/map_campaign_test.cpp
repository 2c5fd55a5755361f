// Campaigns on one's own maps: a folder of them, or map files with drawn or given questions.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "bench/campaign.hpp"
#include "bench/campaign_maps.hpp"
#include "bench/roster.hpp"
#include "bench/trial_plan.hpp"
#include "core/error.hpp"
#include "tests/bench/command_line.hpp"

namespace pathrace::bench {
namespace {

using testing::Finished;
using testing::ScratchFolder;

const char* const head = "[campaign]\nname = \"x\"\n";
const char* const planners =
    "[budget]\nevaluations = 50\n[[planner]]\nname = \"astar\"\n[[planner]]\nname = \"as\"\n";
// Half a metre a cell; a wall with a gap in the lowest row.
const char* const picture =
    "P2\n5 4\n255\n255 255 0 255 255\n255 255 0 255 255\n255 255 0 255 255\n255 255 255 255 255\n";
const char* const yaml = "image: room.pgm\nresolution: 0.5\norigin: [0, 0, 0]\n";

class MapCampaign : public ::testing::Test {
 protected:
  MapCampaign() { std::filesystem::create_directory(scratch_.path() / "maps"); }

  void write_room() {
    scratch_.file("maps/room.pgm", picture);
    scratch_.file("maps/room.yaml", yaml);
  }
  std::string campaign(const std::string& scenarios, const std::string& keys = "") {
    return scratch_.file("x.toml", head + keys + planners + scenarios);
  }
  Finished run(const std::string& file, const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments = {"run", file, "--out", scratch_ / "run", "--backend", "threads"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return pathrace(arguments);
  }
  std::string read(const std::string& name) {
    std::ifstream in(scratch_ / name);
    std::stringstream text;
    text << in.rdbuf();
    return text.str();
  }

  ScratchFolder scratch_;
};

TEST_F(MapCampaign, RosQuestionsAreFoundInTheFolderOfTheFileOrOfTheCommandLine) {
  write_room();
  const std::string select = "[[scenarios]]\nselect = [\"ros/room/1..3\"]\n";
  const Finished named = run(campaign(select, "maps = \"maps\"\n"));
  ASSERT_EQ(named.exit_code, 0) << named.err;
  EXPECT_NE(named.err.find("6 trials"), std::string::npos) << named.err;
  const Finished given = pathrace({"run", campaign(select), "--maps", scratch_ / "maps", "--dry-run"});
  EXPECT_EQ(given.exit_code, 0) << given.err;
  EXPECT_NE(given.out.find("6 trials"), std::string::npos) << given.out;
  expect_refusal(pathrace({"scenarios", "check", campaign("[[scenarios]]\nselect = [\"movingai/*/*\"]\n"),
                           "--maps", scratch_ / "maps"}),
                 {"maps: holds no .scen file"});
}

TEST_F(MapCampaign, AFolderIsRacedOnWhateverItHolds) {
  write_room();
  scratch_.file("maps/digits.csv", "0,0,1\n0,0,0\n");
  scratch_.file("maps/alone.map", "type octile\nheight 1\nwidth 3\nmap\n...\n");
  scratch_.file("maps/wide.txt", "000000\n");
  scratch_.file("maps/notes.txt", "nothing\n");
  const std::string file = campaign("", "maps = \"maps\"\nqueries_per_map = 3\nmax_side = 5\n");
  const Finished raced = run(file);
  ASSERT_EQ(raced.exit_code, 0) << raced.err;
  EXPECT_NE(raced.err.find("2 planners"), std::string::npos) << raced.err;
  for (const char* words : {"left out: ", "wide.txt: 6x1 cells, above 5 a side", "notes.txt:1: "}) {
    EXPECT_NE(raced.err.find(words), std::string::npos) << words << " is not in " << raced.err;
  }
  const std::string trials = read("run/trials.csv");
  for (const char* id : {"ros/room/3", "map/digits/", "map/alone/"}) {
    EXPECT_NE(trials.find(id), std::string::npos) << id;
  }
  EXPECT_EQ(trials.find("wide"), std::string::npos);
  const std::string digest = pathrace({"digest", scratch_ / "run"}).out;
  EXPECT_EQ(pathrace({"verify", scratch_ / "run", "--backend", "threads"}).exit_code, 0);
  EXPECT_EQ(run(file, {"--resume"}).exit_code, 0);
  EXPECT_EQ(pathrace({"run", "--resume", "--out", scratch_ / "run", "--maps", scratch_ / "maps"}).exit_code,
            0);
  EXPECT_EQ(pathrace({"digest", scratch_ / "run"}).out, digest);
  EXPECT_NE(pathrace({"run", file, "--dry-run", "--queries-per-map", "1", "--max-side", "9"})
                .out.find("8 trials (2 planners, 4 scenarios)"),
            std::string::npos);
}

TEST_F(MapCampaign, AnEmptyFolderAndLimitsWithoutAFolderAreRefused) {
  const std::string file = campaign("[[scenarios]]\nselect = [\"asr/fig5\"]\n");
  expect_refusal(run(file, {"--maps", scratch_ / "maps"}), {"maps: holds no map to race on"});
  expect_refusal(run(file, {"--maps", scratch_ / "none"}), {"none: no such folder"});
  expect_refusal(run(file, {"--max-side", "9"}), {"--max-side", "--maps"});
  expect_refusal(run(campaign("")), {"[[scenarios]]"});
}

TEST_F(MapCampaign, AMapFileIsRacedOnInMetresInCellsAndAtRandom) {
  write_room();
  const std::string file = campaign(R"([[scenarios]]
map = "maps/room.yaml"
radius = 0.25
pairs_m = [[0.25, 1.75, 2.25, 1.75], [0.3, 0.2, 2.2, 1]]
pairs = [[0, 0, 1, 3]]
queries = 2
[[scenarios]]
map = "maps/room.pgm"
resolution = 0.1
unknown = "free"
rule = "free"
queries = 1
seed = 9
)");
  const Finished raced = run(file);
  ASSERT_EQ(raced.exit_code, 0) << raced.err;
  EXPECT_NE(raced.err.find("12 trials (2 planners, 6 scenarios)"), std::string::npos) << raced.err;
  const std::string trials = read("run/trials.csv");
  EXPECT_NE(trials.find("\"map/maps-room.yaml,radius=0.25/0,0/4,0\""), std::string::npos) << trials;
  EXPECT_NE(trials.find("\"map/maps-room.yaml,radius=0.25/0,3/4,1\""), std::string::npos) << trials;
  EXPECT_NE(trials.find("\"map/maps-room.yaml,radius=0.25/0,0/1,3\""), std::string::npos) << trials;
  EXPECT_NE(trials.find(",rule=free\""), std::string::npos) << trials;
  EXPECT_EQ(pathrace({"verify", scratch_ / "run", "--backend", "threads"}).exit_code, 0);
  EXPECT_EQ(run(file, {"--resume"}).exit_code, 0);
  EXPECT_EQ(
      pathrace({"run", scratch_ / "run/campaign.toml", "--resume", "--out", scratch_ / "run"}).exit_code, 0);
  // One more blocked cell: other questions than those in the store.
  scratch_.file("maps/room.pgm",
                "P2\n5 4\n255\n255 0 0 255 255\n255 255 0 255 255\n255 255 0 255 255\n255 255 255 255 255\n");
  expect_refusal(run(file, {"--resume"}), {"another campaign", "map files must be the same"});
}

TEST_F(MapCampaign, PlanRepeatsARowOfAMapFile) {
  write_room();
  const std::string map = scratch_ / "maps/room.yaml";
  ASSERT_EQ(
      run(campaign("[[scenarios]]\nmap = \"maps/room.yaml\"\nrule = \"squeeze\"\npairs = [[0, 0, 4, 0]]\n"))
          .exit_code,
      0);
  const Finished plan =
      pathrace({"plan", "--map", map, "--start", "0,0", "--goal", "4,0", "--rule", "squeeze", "--planner",
                "as", "--evaluations", "50", "--json", "--backend", "threads"});
  ASSERT_EQ(plan.exit_code, 0) << plan.err;
  const std::string digest = nlohmann::json::parse(plan.out)["digest"];
  EXPECT_NE(read("run/trials.csv").find(digest), std::string::npos);
}

TEST_F(MapCampaign, RulesAreRacedOnTheLibraryToo) {
  const std::string file =
      campaign("[[scenarios]]\nselect = [\"asr/fig5\", \"asr/fig2\"]\nrule = \"free\"\n");
  ASSERT_EQ(run(file).exit_code, 0);
  EXPECT_NE(read("run/trials.csv").find("asr/fig5,rule=free"), std::string::npos);
  EXPECT_EQ(pathrace({"verify", scratch_ / "run", "--backend", "threads"}).exit_code, 0);
}

TEST_F(MapCampaign, QuestionsWithoutAWayAreLeftOut) {
  scratch_.file("maps/split.map", "type octile\nheight 3\nwidth 3\nmap\n.@.\n.@.\n.@.\n");
  scratch_.file("maps/split.scen",
                "version 1\n0\tsplit.map\t3\t3\t0\t0\t2\t2\t0\n0\tsplit.map\t3\t3\t0\t0\t0\t2\t2\n");
  const Finished raced = run(campaign("", "maps = \"maps\"\n"));
  ASSERT_EQ(raced.exit_code, 0) << raced.err;
  EXPECT_NE(raced.err.find("left out: movingai/split/1: no way from 0,0 to 2,2"), std::string::npos)
      << raced.err;
  EXPECT_NE(raced.err.find("1 scenarios"), std::string::npos) << raced.err;
  const Finished pair = pathrace(
      {"run", campaign("[[scenarios]]\nmap = \"maps/split.map\"\npairs = [[0, 0, 2, 2], [0, 0, 0, 2]]\n"),
       "--dry-run"});
  EXPECT_NE(pair.err.find("left out: map/split/0,0/2,2: no way"), std::string::npos) << pair.err;
}

TEST_F(MapCampaign, WhatIsWrongWithAMapIsOneLine) {
  write_room();
  const auto says = [&](const std::string& keys, const std::vector<std::string>& words) {
    expect_refusal(run(campaign("[[scenarios]]\nmap = \"maps/room.yaml\"\n" + keys)), words);
  };
  says("pairs_m = [[0.2, 0.2, 2.2, 1.7], [1.3, 1.7, 0.2, 0.2]]\n",
       {"pairs_m 2: ", "room.yaml: start 1.3 m, 1.7 m (cell 2,0) is a blocked cell; the nearest free cell"});
  says("pairs = [[0, 0, 9, 9]]\n", {"pairs 1: ", "goal 9,9 is outside"});
  says("pairs = [[0, 0, 9]]\n", {"x.toml:", "[start x, start y, goal x, goal y] in cells"});
  says("pairs_m = [[0, 0, \"a\", 1]]\n", {"x.toml:", "in metres"});
  says("radius = -1\n", {"x.toml:", "'radius' must be a number of at least 0"});
  says("unknown = \"fre\"\n", {"x.toml:", "'free'"});
  says("rule = \"fre\"\n", {"x.toml:", "'free'"});
  says("radis = 1\n", {"x.toml:", "'radius'"});
  says("queries = 0\n", {"x.toml:", "queries", "got 0"});
  says("resolution = 1\n", {"room.yaml: says its resolution itself"});
  says("radius = 9\n", {"room.yaml: the largest region has 0 free cells"});
  expect_refusal(run(campaign("[[scenarios]]\nmap = \"maps/none.yaml\"\n")), {"none.yaml"});
}

TEST(MapCampaignToml, EveryKeySurvivesBeingPrintedAndReadAgain) {
  const std::string text =
      std::string(head) + "maps = \"/m\"\nqueries_per_map = 5\nmax_side = 900\n" + planners + R"(
[[scenarios]]
map = "/m/a.yaml"
radius = 0.2
unknown = "threshold"
rule = "squeeze"
queries = 4
seed = 12
pairs = [[1, 2, 3, 4]]
pairs_m = [[0.1, 2, -3.5, 1e-3], [1, 2, 3, 4]]
[[scenarios]]
map = "/m/b.png"
resolution = 0.05
)";
  const Campaign once = parse_campaign(text, "x.toml");
  const Campaign again = parse_campaign(to_toml(once), "printed.toml");
  EXPECT_EQ(to_toml(again), to_toml(once));
  EXPECT_EQ(again.limits.queries_per_map, 5U);
  EXPECT_EQ(again.limits.max_side, 900);
  const MapChoice& map = again.scenarios[0].map.value();
  EXPECT_EQ(map.file, "/m/a.yaml");
  EXPECT_EQ(map.options.radius, 0.2);
  EXPECT_EQ(map.options.unknown, scenarios::UnknownPolicy::threshold);
  EXPECT_EQ(again.scenarios[0].rule, MoveRule::squeeze);
  EXPECT_EQ(map.queries, 4U);
  EXPECT_EQ(map.seed, 12U);
  EXPECT_EQ(map.pairs, (std::vector<std::array<int, 4>>{{1, 2, 3, 4}}));
  EXPECT_EQ(map.pairs_m, (std::vector<std::array<double, 4>>{{0.1, 2, -3.5, 1e-3}, {1, 2, 3, 4}}));
  EXPECT_EQ(again.scenarios[1].map->options.resolution, 0.05);
  EXPECT_EQ(again.scenarios[1].map->queries, 5U);  // as many as of a map in the folder
}

}  // namespace
}  // namespace pathrace::bench
