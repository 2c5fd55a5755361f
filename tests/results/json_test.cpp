#include "results/json.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "tests/results/rows.hpp"
#include "tests/support/maps.hpp"

namespace pathrace::results {
namespace {

using Json = nlohmann::ordered_json;

Scenario some_scenario() {
  Scenario scenario;
  scenario.id = "trap-u/20/1";
  scenario.terrain = pathrace::testing::terrain_of(pathrace::testing::grid_of({"..."}));
  scenario.goal = {2, 0};
  return scenario;
}

std::vector<std::string> keys_of(const Json& object) {
  std::vector<std::string> keys;
  for (const auto& item : object.items()) keys.push_back(item.key());
  return keys;
}

TEST(Json, HasTheAgreedKeysInTheirOrder) {
  TrialRow row = solved_row(1, "a", "trap-u/20/1");
  std::vector<std::string> keys = {
      "scenario",    "planner",    "verdict",  "track",    "rule",    "length",  "optimum",
      "gap",         "turns",      "cells",    "length_m", "start_m", "goal_m",  "points_m",
      "evaluations", "iterations", "checks",   "digest",   "backend", "threads", "threads_used",
      "wall_s",      "user_s",     "system_s", "note",     "counters"};
  EXPECT_EQ(keys_of(Json::parse(to_json(row, some_scenario()))), keys);
  row.track = Track::any_angle;
  keys[9] = "points";
  EXPECT_EQ(keys_of(Json::parse(to_json(row, some_scenario()))), keys);
}

TEST(Json, HasMetresWhereTheMapHasAFrame) {
  const TrialRow row = solved_row(1, "a", "trap-u/20/1");
  EXPECT_TRUE(Json::parse(to_json(row, some_scenario())).at("points_m").is_null());
  InMetres metres;
  metres.length = 1.5;
  metres.start = {-1, 0.25};
  metres.points = {{-1, 0.25}, {0.5, 0.25}};
  const Json object = Json::parse(to_json(row, some_scenario(), metres));
  EXPECT_EQ(object["length_m"], 1.5);
  EXPECT_EQ(object["start_m"].dump(), "[-1.0,0.25]");
  EXPECT_EQ(object["goal_m"].dump(), "[0.0,0.0]");
  EXPECT_EQ(object["points_m"].dump(), "[[-1.0,0.25],[0.5,0.25]]");
}

TEST(Json, OfARunInADynamicWorldHasItsFigures) {
  Scenario scenario = some_scenario();
  scenario.world = std::make_shared<const World>();
  const Json object = Json::parse(to_json(run_row(1, "straight", "discs/open/1"), scenario));
  EXPECT_EQ(object["steps"], 30);
  EXPECT_EQ(object["least_steps"], 20);
  EXPECT_EQ(object["travelled"], 88.5);
  EXPECT_EQ(object["collisions"], 0);
  EXPECT_EQ(object["struck"], 1);
  EXPECT_EQ(object["min_clearance"], 0.25);
  EXPECT_EQ(object["oscillations"], 2);
  EXPECT_EQ(object["world_hash"], "fedcba9876543210");
  EXPECT_EQ(object["step_ms_median"], 0.125);
  EXPECT_EQ(object["step_ms_p99"], 0.5);
  EXPECT_EQ(object["points"].dump(), "[[0.5,0],[1,0.25]]");
}

TEST(Json, SaysWhatTheRowSays) {
  TrialRow row = solved_row(1, "as:a=1,b=\"2\"", "trap-u/20/1");
  row.gap = 0.1;
  row.digest = 255;
  const Json object = Json::parse(to_json(row, some_scenario()));
  EXPECT_EQ(object["scenario"], "trap-u/20/1");
  EXPECT_EQ(object["planner"], "as:a=1,b=\"2\"");
  EXPECT_EQ(object["verdict"], "solved");
  EXPECT_EQ(object["track"], "lattice");
  EXPECT_EQ(object["rule"], "strict");
  EXPECT_EQ(object["length"], 2.0);
  EXPECT_EQ(object["optimum"], 2.0);
  EXPECT_EQ(object["gap"], 0.1);
  EXPECT_EQ(object["turns"], 0);
  EXPECT_EQ(object["evaluations"], 1);
  EXPECT_EQ(object["iterations"], 1);
  EXPECT_EQ(object["checks"], 3);
  EXPECT_EQ(object["digest"], "00000000000000ff");
  EXPECT_EQ(object["backend"], "serial");
  EXPECT_EQ(object["threads"], 1);
  EXPECT_EQ(object["threads_used"], 1);
  EXPECT_EQ(object["wall_s"], 0.001);
  EXPECT_TRUE(object["note"].is_null());
}

TEST(Json, WritesCellsAsIntegersOnOneLine) {
  const std::string text = to_json(solved_row(1, "a", "trap-u/20/1"), some_scenario());
  EXPECT_NE(text.find("\n  \"cells\": [[0,0],[1,0],[2,0]],\n"), std::string::npos) << text;
}

TEST(Json, WritesPointsAsTheyAre) {
  TrialRow row = solved_row(1, "a", "trap-u/20/1");
  row.track = Track::any_angle;
  row.answer = Path{Track::any_angle, {{0, 0}, {1.5, 0.1}}};
  EXPECT_EQ(Json::parse(to_json(row, some_scenario()))["points"].dump(), "[[0,0],[1.5,0.1]]");
}

TEST(Json, HasNullWhereThereIsNoValue) {
  TrialRow row = failed_row(1, "a", "trap-u/20/1");
  row.optimum = std::nullopt;
  row.note = "evaluations are spent";
  row.counters = {{"arrived", 12}, {"pops", 3}};
  const Json object = Json::parse(to_json(row, some_scenario()));
  for (const char* key : {"length", "optimum", "gap", "turns", "cells"})
    EXPECT_TRUE(object[key].is_null()) << key;
  EXPECT_EQ(object["verdict"], "budget");
  EXPECT_EQ(object["note"], "evaluations are spent");
  EXPECT_EQ(object["counters"], Json::parse(R"({"arrived": 12, "pops": 3})"));
}

TEST(Json, OfAnEmptyPathIsAnEmptyListAndNotNull) {
  TrialRow row = failed_row(1, "a", "trap-u/20/1");
  row.answer = Path{};
  EXPECT_EQ(Json::parse(to_json(row, some_scenario()))["cells"], Json::array());
}

TEST(Json, SurvivesStrangeTextAndNumbers) {
  TrialRow row = solved_row(1, "caf\xE9 \n \"x\"", "trap-u/20/1");
  row.answer->points[1].x = std::numeric_limits<double>::quiet_NaN();
  row.answer->points[2].x = 1e300;
  const Json object = Json::parse(to_json(row, some_scenario()));
  EXPECT_EQ(object["planner"], "caf\xEF\xBF\xBD \n \"x\"");
  EXPECT_TRUE(object["cells"][1][0].is_null());
  EXPECT_EQ(object["cells"][2][0], 1e300);
}

}  // namespace
}  // namespace pathrace::results
