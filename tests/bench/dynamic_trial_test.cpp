// One trial in a dynamic world: every verdict, brought about by a navigator that misbehaves in just that way;
// and the dynamic track on the command line.
#include "bench/dynamic_trial.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <map>
#include <new>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "bench/trial_plan.hpp"
#include "core/error.hpp"
#include "core/hash.hpp"
#include "core/world_motion.hpp"
#include "tests/support/process.hpp"
#include "tests/support/trials.hpp"
#include "tests/support/worlds.hpp"

namespace pathrace::bench {
namespace {

using testing::Finished;
using testing::run_program;
using testing::ScratchFolder;
using testing::still_world;
using Json = nlohmann::json;
using Steer = std::function<Point(const Snapshot&, Context&)>;

class Puppet final : public Navigator {
 public:
  explicit Puppet(Steer steer) : steer_(std::move(steer)) {}
  Point next(const Snapshot& snapshot, Context& context) override { return steer_(snapshot, context); }

 private:
  Steer steer_;
};

struct Nothing {};

TrialRecord trial_of(const Steer& steer, const World& world = still_world(), const Budget& budget = {}) {
  PlannerCard card;
  card.name = "test";
  card = with_navigator_parameters(std::move(card), Schema<Nothing>{{}},
                                   [&steer](const Nothing&) { return std::make_unique<Puppet>(steer); });
  const Entrant entrant{&card, {}, "test"};
  const auto executor = make_executor("serial", 1);
  return run_dynamic_trial(entrant, *settled(world, "test"), budget, Stream(1), *executor);
}

Point ahead(const Snapshot& snapshot, Context&) {
  return {snapshot.robot.x + snapshot.robot_step, snapshot.robot.y};
}

TEST(DynamicTrial, ARunThatArrivesWithoutACollisionIsSolvedAndMeasured) {
  const TrialRecord record = trial_of(ahead);
  ASSERT_EQ(record.verdict, Verdict::solved) << record.note;
  EXPECT_EQ(record.run->steps, 26U);
  EXPECT_EQ(record.work.iterations, 26U);
  EXPECT_EQ(record.answer->track, Track::dynamic);
  EXPECT_EQ(record.answer->points.size(), 27U);
  EXPECT_TRUE(record.costs.step_ms_median && record.costs.step_ms_p99);
  EXPECT_LE(*record.costs.step_ms_median, *record.costs.step_ms_p99);
}

TEST(DynamicTrial, TheTraceIsTheDistanceToTheGoalWheneverItWasLeast) {
  const TrialRecord record = trial_of(ahead);
  ASSERT_EQ(record.trace.size(), 26U);
  EXPECT_EQ(record.trace.front().cost, 77);
  EXPECT_EQ(record.trace.back().cost, 2);
}

TEST(DynamicTrial, ArrivingWithACollisionIsInvalidAndStillMeasured) {
  World world = still_world();
  world.discs = {{{50, 50}, 2}};
  const TrialRecord record = trial_of(ahead, world);
  EXPECT_EQ(record.verdict, Verdict::invalid);
  EXPECT_NE(record.note.find("collision"), std::string::npos) << record.note;
  ASSERT_TRUE(record.run.has_value());
  EXPECT_GT(record.run->collisions, 0U);
  EXPECT_TRUE(record.answer.has_value());
}

TEST(DynamicTrial, NotArrivingInTheStepsThereAreIsASpentBudget) {
  const TrialRecord record = trial_of([](const Snapshot& snapshot, Context&) { return snapshot.robot; });
  EXPECT_EQ(record.verdict, Verdict::budget);
  EXPECT_EQ(record.run->steps, 500U);
  EXPECT_EQ(record.note, "not arrived after 500 steps");
}

TEST(DynamicTrial, StepsAreIterationsOfTheBudget) {
  Budget budget;
  budget.iterations = 5;
  const TrialRecord record = trial_of(ahead, still_world(), budget);
  EXPECT_EQ(record.verdict, Verdict::budget);
  EXPECT_EQ(record.run->steps, 5U);
}

TEST(DynamicTrial, AStepThatIsTooLongIsInvalid) {
  const TrialRecord record = trial_of([](const Snapshot& snapshot, Context&) { return snapshot.goal; });
  EXPECT_EQ(record.verdict, Verdict::invalid);
  EXPECT_NE(record.note.find("longer than V_robot"), std::string::npos);
  EXPECT_FALSE(record.run.has_value());
}

TEST(DynamicTrial, APositionThatIsNoNumberEndsTheRunAsInvalid) {
  const TrialRecord record = trial_of([](const Snapshot&, Context&) {
    return Point{std::numeric_limits<double>::quiet_NaN(), 1};
  });
  EXPECT_EQ(record.verdict, Verdict::invalid);
  EXPECT_EQ(record.work.iterations, 1U);
}

TEST(DynamicTrial, SpendingMoreThanTheBudgetIsInvalid) {
  Budget budget;
  budget.checks = 3;
  const TrialRecord record = trial_of(
      [](const Snapshot& snapshot, Context& context) {
        context.meter.spend_checks(2);
        return ahead(snapshot, context);
      },
      still_world(), budget);
  EXPECT_EQ(record.verdict, Verdict::invalid);
  EXPECT_NE(record.note.find("4 checks"), std::string::npos) << record.note;
}

TEST(DynamicTrial, WhoeverMeddlesWithTheWorldIsFoundOut) {
  World world = still_world();
  world.discs = {{{50, 80}, 5}};
  world.disc_chance = 1;
  const TrialRecord record = trial_of(
      [](const Snapshot& snapshot, Context& context) {
        const_cast<Disc&>(snapshot.discs[0]).centre.x += 0.5;
        return ahead(snapshot, context);
      },
      world);
  EXPECT_EQ(record.verdict, Verdict::invalid);
  EXPECT_NE(record.note.find("meddled"), std::string::npos) << record.note;
}

TEST(DynamicTrial, WhatANavigatorThrowsIsItsVerdict) {
  const auto verdict_of = [](const Steer& steer) { return trial_of(steer).verdict; };
  EXPECT_EQ(verdict_of([](const Snapshot&, Context&) -> Point { throw std::bad_alloc(); }),
            Verdict::out_of_memory);
  EXPECT_EQ(verdict_of([](const Snapshot&, Context&) -> Point { throw Unsupported("no"); }),
            Verdict::unsupported);
  EXPECT_EQ(verdict_of([](const Snapshot&, Context&) -> Point { throw std::runtime_error("x"); }),
            Verdict::crashed);
  EXPECT_EQ(verdict_of([](const Snapshot&, Context&) -> Point { throw 3; }), Verdict::crashed);
}

TEST(DynamicTrial, TheWorldMovesBeforeTheRobotPlansAndNotBeforeItHasArrived) {
  World world = still_world();
  world.goal_law = GoalLaw::way_points;
  world.goal_chance = 1;
  world.goal_step = 1;
  world.way_points = {{90, 80}};
  std::vector<double> seen;
  trial_of(
      [&seen](const Snapshot& snapshot, Context& context) {
        if (seen.size() < 3) seen.push_back(snapshot.goal.y);
        return ahead(snapshot, context);
      },
      world);
  EXPECT_EQ(seen, (std::vector<double>{51, 52, 53}));  // moved once before the first step
}

TEST(DynamicTrial, EachStepHasAStreamOfItsOwn) {
  std::vector<std::uint64_t> drawn;
  trial_of([&drawn](const Snapshot& snapshot, Context& context) {
    if (drawn.size() < 3) drawn.push_back(context.stream.bits());
    return ahead(snapshot, context);
  });
  EXPECT_EQ(drawn, (std::vector<std::uint64_t>{Stream(1).fork(0).bits(), Stream(1).fork(1).bits(),
                                               Stream(1).fork(2).bits()}));
}

// --- campaigns -------------------------------------------------------------------------------------

std::vector<std::string> pairs(const std::string& planners, const std::string& select) {
  std::string text = "[campaign]\nname = \"x\"\n";
  std::istringstream names(planners);
  for (std::string name; names >> name;) text += "[[planner]]\nname = \"" + name + "\"\n";
  text += "[[scenarios]]\nselect = [" + select + "]\n";
  const TrialPlan plan = plan_trials(parse_campaign(text, "x.toml"), scenarios::Library(), roster());
  std::vector<std::string> found;
  for (std::size_t i = 0; i < plan.size(); ++i) {
    const Trial trial = plan.trial(i);
    found.push_back(plan.entrants[trial.entrant].label + " " + plan.scenarios[trial.scenario].id);
  }
  return found;
}

TEST(DynamicCampaign, PlannersRaceOnMapsAndNavigatorsInWorlds) {
  EXPECT_EQ(
      pairs("astar straight replan(astar)", R"("asr/fig2", "discs/open/1")"),
      (std::vector<std::string>{"astar asr/fig2", "straight discs/open/1", "replan(astar) discs/open/1"}));
}

TEST(DynamicCampaign, WhoCanRaceNowhereIsRecordedAllTheSame) {
  EXPECT_EQ(pairs("astar straight", R"("discs/open/1")"),
            (std::vector<std::string>{"astar discs/open/1", "straight discs/open/1"}));
  EXPECT_EQ(pairs("straight", R"("asr/fig2")"), std::vector<std::string>{"straight asr/fig2"});
}

constexpr const char* dynamic_campaign = R"([campaign]
name = "dynamic"
[[planner]]
name = "straight"
[[planner]]
name = "potential-field"
[[planner]]
name = 'replan(astar)'
params = { resolution = 2 }
[[scenarios]]
select = ["discs/*/1"]
budget = { iterations = 60 }
)";

TEST(DynamicCampaign, HasOneDigestOnEveryBackendAndVerifies) {
  const ScratchFolder scratch;
  const std::string campaign = scratch.file("dynamic.toml", dynamic_campaign);
  std::string expected;
  int n = 0;
  for (const std::string& backend : testing::executors_under_test()) {
    const std::string folder = scratch / std::to_string(n++);
    const Finished run = run_program(PATHRACE_BINARY, {"run", campaign, "--out", folder, "--backend", backend,
                                                       "--threads", "2", "--jobs", "2"});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const std::string digest = run_program(PATHRACE_BINARY, {"digest", folder}).out;
    if (expected.empty()) expected = digest;
    EXPECT_EQ(digest, expected) << backend;
  }
  const Finished verified = run_program(PATHRACE_BINARY, {"verify", scratch / "0"});
  EXPECT_EQ(verified.exit_code, 0) << verified.out << verified.err;
}

TEST(DynamicCampaign, EveryRowOfAScenarioNamesTheSameWorld) {
  const ScratchFolder scratch;
  ASSERT_EQ(run_program(PATHRACE_BINARY,
                        {"run", scratch.file("d.toml", dynamic_campaign), "--out", scratch / "run"})
                .exit_code,
            0);
  std::ifstream file(scratch / "run/trials.csv");
  std::string line;
  std::getline(file, line);
  EXPECT_NE(
      line.find(",steps,travelled,collisions,struck,min_clearance,oscillations,world_hash,least_steps,"),
      std::string::npos)
      << line;
  const auto behind =
      std::count(line.begin() + static_cast<std::ptrdiff_t>(line.find("world_hash")), line.end(), ',');
  std::map<std::string, std::set<std::string>> worlds;
  while (std::getline(file, line)) {
    const std::size_t id = line.find("discs/");
    const std::string scenario = line.substr(id, line.find(',', id) - id);
    std::size_t comma = line.size();
    for (auto k = behind; k > 0; --k) comma = line.rfind(',', comma - 1);
    const std::size_t before = line.rfind(',', comma - 1);
    worlds[scenario].insert(line.substr(before + 1, comma - before - 1));
  }
  ASSERT_EQ(worlds.size(), 6U);
  for (const auto& [scenario, hashes] : worlds) {
    EXPECT_EQ(hashes, std::set<std::string>{hex(content_hash(scenarios::Library().load(scenario)))})
        << scenario;
  }
}

// --- plan ------------------------------------------------------------------------------------------

TEST(DynamicPlan, PrintsTheAgreedKeys) {
  const Finished finished = run_program(
      PATHRACE_BINARY, {"plan", "--scenario", "discs/open/1", "--planner", "replan(astar)", "--json"});
  ASSERT_EQ(finished.exit_code, 0) << finished.err;
  const Json object = Json::parse(finished.out);
  EXPECT_EQ(object["track"], "dynamic");
  EXPECT_EQ(object["planner"], "replan(astar)");
  for (const char* key :
       {"steps", "travelled", "collisions", "struck", "min_clearance", "world_hash", "points"}) {
    EXPECT_TRUE(object.contains(key) && !object[key].is_null()) << key;
  }
  EXPECT_EQ(object["points"].size(), object["steps"].get<std::size_t>() + 1);
  EXPECT_EQ(object["world_hash"], hex(content_hash(scenarios::Library().load("discs/open/1"))));
}

TEST(DynamicPlan, DrawsTheRunAndAFramePerStep) {
  const ScratchFolder scratch;
  const Finished finished =
      run_program(PATHRACE_BINARY, {"plan", "--scenario", "discs/ring/1", "--planner", "straight",
                                    "--iterations", "3", "--svg", scratch / "run.svg", "--frames",
                                    scratch / "frames", "--trace", scratch / "trace.csv"});
  ASSERT_EQ(finished.exit_code, 0) << finished.err;
  for (const char* frame : {"0000.png", "0001.png", "0002.png", "0003.png"}) {
    EXPECT_TRUE(std::filesystem::exists(scratch / (std::string("frames/") + frame))) << frame;
  }
  EXPECT_FALSE(std::filesystem::exists(scratch / "frames/0004.png"));
  std::ostringstream svg;
  svg << std::ifstream(scratch / "run.svg").rdbuf();
  EXPECT_NE(svg.str().find("3 steps"), std::string::npos);
}

TEST(DynamicPlan, RefusesWhatHasNoMeaning) {
  const Finished frames =
      run_program(PATHRACE_BINARY, {"plan", "--scenario", "asr/fig2", "--planner", "astar", "--frames", "x"});
  EXPECT_EQ(frames.exit_code, 2);
  EXPECT_NE(frames.err.find("--frames"), std::string::npos);
  const Finished rule = run_program(
      PATHRACE_BINARY, {"plan", "--scenario", "discs/open/1", "--planner", "straight", "--rule", "four"});
  EXPECT_EQ(rule.exit_code, 2);
  EXPECT_NE(rule.err.find("--rule"), std::string::npos);
}

TEST(DynamicPlan, AStaticPlannerIsUnsupportedAndSaysWhy) {
  const Finished finished =
      run_program(PATHRACE_BINARY, {"plan", "--scenario", "discs/open/1", "--planner", "astar", "--json"});
  ASSERT_EQ(finished.exit_code, 0) << finished.err;
  const Json object = Json::parse(finished.out);
  EXPECT_EQ(object["verdict"], "unsupported");
  EXPECT_TRUE(object["steps"].is_null());
}

}  // namespace
}  // namespace pathrace::bench
