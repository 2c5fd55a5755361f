#include "core/catalogue.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "core/error.hpp"
#include "tests/support/maps.hpp"

namespace pathrace {
namespace {

struct Settings {
  int ants = 50;
  double phi = 0.5;
  MoveRule rule = MoveRule::strict;
};

class Serial final : public Executor {
 public:
  std::string_view name() const override { return "serial"; }
  int threads() const override { return 1; }

 private:
  void run_chunks(std::size_t count, std::size_t, ChunkBody body) override { body(0, count); }
};

// Answers with one point whose row is the number of ants.
Planner ant_counter(const Settings& settings) {
  return unprepared([settings](const Problem& problem, Context&) -> Answer {
    return lattice_path({problem.start, {settings.ants, 0}});
  });
}

Planner give_up() {
  return unprepared([](const Problem&, Context&) -> Answer { return std::nullopt; });
}

PlannerCard named(std::string name) {
  PlannerCard card;
  card.name = std::move(name);
  return card;
}

Catalogue catalogue() {
  const Schema<Settings> schema{{
      integer("ants", &Settings::ants, 1, 1000, "ants", Source::field, "ants"),
      real("phi", &Settings::phi, 0, 2, "cells", Source::paper, "price of a turn"),
      choice("rule", &Settings::rule, Source::ours, "how it moves"),
  }};
  return Catalogue({with_parameters(named("tan"), schema, ant_counter),
                    without_parameters(named("astar"), give_up()),
                    without_parameters(named("dijkstra"), give_up())});
}

std::string refusal(const std::function<void()>& act) {
  try {
    act();
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

Entrant enter(const Catalogue& catalogue, std::string_view call) {
  return catalogue.enter(parse_call(call));
}

Answer run(const Planner& planner) {
  Serial executor;
  Meter meter({});
  Context context{Stream(0), executor, meter};
  const Terrain terrain = testing::terrain_of(OccupancyGrid(2, 2));
  return planner(terrain)->plan({1, 1}, {0, 0}, context);
}

TEST(PlannerCall, IsANameAndValues) {
  const PlannerCall bare = parse_call("astar");
  EXPECT_EQ(bare.name, "astar");
  EXPECT_TRUE(bare.values.empty());
  const PlannerCall full = parse_call("tan:phi=0.5,dead_table=global_literal");
  EXPECT_EQ(full.name, "tan");
  EXPECT_EQ(full.values, (ParameterValues{{"phi", "0.5"}, {"dead_table", "global_literal"}}));
}

TEST(PlannerCall, AValueMayBeEmptyOrHoldAnEqualsSign) {
  EXPECT_EQ(parse_call("tan:a=").values, (ParameterValues{{"a", ""}}));
  EXPECT_EQ(parse_call("tan:a=b=c").values, (ParameterValues{{"a", "b=c"}}));
}

TEST(PlannerCall, APlannerInParenthesesIsAValue) {
  EXPECT_EQ(parse_call("replan(astar)").name, "replan");
  EXPECT_EQ(parse_call("replan(astar)").values, (ParameterValues{{"planner", "astar"}}));
  EXPECT_EQ(parse_call("replan(as:ants=5,phi=1):resolution=2").values,
            (ParameterValues{{"planner", "as:ants=5,phi=1"}, {"resolution", "2"}}));
  EXPECT_EQ(parse_call("replan:planner=(as:ants=5,phi=1),resolution=2").values,
            (ParameterValues{{"planner", "(as:ants=5,phi=1)"}, {"resolution", "2"}}));
  EXPECT_EQ(parse_call("a(b(c:d=1,e=2))").values, (ParameterValues{{"planner", "b(c:d=1,e=2)"}}));
}

TEST(PlannerCall, RefusesParenthesesThatDoNotFit) {
  const auto refused = [](const std::string& text) { return refusal([&] { parse_call(text); }); };
  EXPECT_EQ(refused("replan(astar"), "planner call 'replan(astar': a ')' is missing");
  EXPECT_EQ(refused("replan(astar)x"), "planner call 'replan(astar)x': expected ':', got 'x'");
  EXPECT_EQ(refused("replan(astar):planner=as"),
            "planner call 'replan(astar):planner=as' gives 'planner' twice");
}

TEST(PlannerCall, RefusesWhatIsNoCall) {
  const auto refused = [](const std::string& text) { return refusal([&] { parse_call(text); }); };
  EXPECT_EQ(refused(""), "planner call '' names no planner");
  EXPECT_EQ(refused(":ants=5"), "planner call ':ants=5' names no planner");
  EXPECT_EQ(refused("tan:"), "planner call 'tan:': expected key=value, got ''");
  EXPECT_EQ(refused("tan:ants"), "planner call 'tan:ants': expected key=value, got 'ants'");
  EXPECT_EQ(refused("tan:=5"), "planner call 'tan:=5': expected key=value, got '=5'");
  EXPECT_EQ(refused("tan:ants=5,"), "planner call 'tan:ants=5,': expected key=value, got ''");
  EXPECT_EQ(refused("tan:ants=5,ants=6"), "planner call 'tan:ants=5,ants=6' gives 'ants' twice");
}

TEST(Catalogue, ListsItsCardsByName) {
  const Catalogue all = catalogue();
  ASSERT_EQ(all.cards().size(), 3U);
  EXPECT_EQ(all.cards()[0].name, "astar");
  EXPECT_EQ(all.cards()[1].name, "dijkstra");
  EXPECT_EQ(all.cards()[2].name, "tan");
  EXPECT_EQ(all.cards()[2].parameters.size(), 3U);
}

TEST(Catalogue, FindsACardOrNamesTheNearestMatch) {
  const Catalogue all = catalogue();
  EXPECT_EQ(all.find("astar").name, "astar");
  EXPECT_EQ(refusal([&] { (void)all.find("asta"); }), "unknown planner 'asta'; the nearest match is 'astar'");
  EXPECT_EQ(refusal([&] { (void)all.find("TAN"); }).substr(0, 21), "unknown planner 'TAN'");
}

TEST(Catalogue, SaysWhatAnAbsentPlannerNeeds) {
  const Catalogue some({without_parameters(named("astar"), give_up())}, {{"rrt", "OMPL: install it"}});
  EXPECT_EQ(refusal([&] { (void)some.find("rrt"); }), "planner 'rrt' needs OMPL: install it");
  EXPECT_EQ(refusal([&] { (void)some.find("rtr"); }), "unknown planner 'rtr'; the nearest match is 'rrt'");
  ASSERT_NE(some.absent("rrt"), nullptr);
  EXPECT_EQ(some.absent("rrt")->needs, "OMPL: install it");
  EXPECT_EQ(some.absent("astar"), nullptr);
  EXPECT_EQ(some.absent("rtr"), nullptr);
}

TEST(Catalogue, AnEntrantKnowsEveryParameter) {
  const Catalogue all = catalogue();
  const Entrant entrant = enter(all, "tan:ants=20");
  EXPECT_EQ(entrant.card, &all.find("tan"));
  EXPECT_EQ(entrant.full_call(), "tan:ants=20,phi=0.5,rule=strict");
  EXPECT_EQ(enter(all, "astar").full_call(), "astar");
}

TEST(Catalogue, TheLabelIsTheShortestCallThatMeansTheSame) {
  const Catalogue all = catalogue();
  EXPECT_EQ(enter(all, "tan").label, "tan");
  EXPECT_EQ(enter(all, "tan:ants=50").label, "tan");
  EXPECT_EQ(enter(all, "tan:ants=050,phi=5e-1,rule=strict").label, "tan");
  EXPECT_EQ(enter(all, "tan:rule=free,ants=020").label, "tan:ants=20,rule=free");
  EXPECT_EQ(enter(all, "tan:phi=-0").label, enter(all, "tan:phi=0").label);
  EXPECT_EQ(enter(all, "astar").label, "astar");
}

TEST(Catalogue, ALabelThatWasGivenStays) {
  const Catalogue all = catalogue();
  EXPECT_EQ(all.enter(parse_call("tan:ants=20"), "few ants").label, "few ants");
}

TEST(Catalogue, CallsThatMeanTheSameHaveTheSameFullCall) {
  const Catalogue all = catalogue();
  EXPECT_EQ(enter(all, "tan:ants=050,phi=0.50").full_call(), enter(all, "tan").full_call());
  EXPECT_NE(enter(all, "tan:ants=51").full_call(), enter(all, "tan").full_call());
}

TEST(Catalogue, AFullCallCanBeEnteredAgain) {
  const Catalogue all = catalogue();
  const Entrant entrant = enter(all, "tan:ants=20,phi=0.1");
  EXPECT_EQ(enter(all, entrant.full_call()).full_call(), entrant.full_call());
  EXPECT_EQ(enter(all, entrant.label).full_call(), entrant.full_call());
}

TEST(Catalogue, ABadValueNamesThePlanner) {
  const Catalogue all = catalogue();
  EXPECT_EQ(refusal([&] { enter(all, "tan:ants=0"); }),
            "planner 'tan': 'ants' must be an integer in 1..1000, got '0'");
  EXPECT_EQ(refusal([&] { enter(all, "tan:ant=5"); }),
            "planner 'tan': unknown parameter 'ant'; the nearest match is 'ants'");
  EXPECT_EQ(refusal([&] { enter(all, "astar:ants=5"); }),
            "planner 'astar': unknown parameter 'ants'; there are none");
}

TEST(Catalogue, MakesAPlannerWithTheSettledValues) {
  const Catalogue all = catalogue();
  const Entrant entrant = enter(all, "tan:ants=20");
  EXPECT_EQ(run(entrant.card->make(entrant.values)), lattice_path({{1, 1}, {20, 0}}));
  EXPECT_EQ(run(all.find("astar").make({})), std::nullopt);
}

TEST(Planner, OneThatPreparesNothingSeesTheQuestionAsAsked) {
  const Terrain terrain = testing::terrain_of(testing::grid_of({".#", ".."}), MoveRule::squeeze);
  int asked = 0;
  const Planner planner = unprepared([&](const Problem& problem, Context& context) -> Answer {
    ++asked;
    EXPECT_EQ(&problem.grid, terrain.grid.get());
    EXPECT_EQ(problem.rule, MoveRule::squeeze);
    EXPECT_EQ(problem.start, (Cell{0, 0}));
    EXPECT_EQ(problem.goal, (Cell{1, 1}));
    context.meter.spend_evaluations(1);
    return lattice_path({problem.start, problem.goal});
  });
  Serial executor;
  Meter meter({});
  Context context{Stream(0), executor, meter};
  const auto on_map = planner(terrain);
  EXPECT_EQ(on_map->plan({0, 0}, {1, 1}, context), lattice_path({{0, 0}, {1, 1}}));
  EXPECT_EQ(on_map->plan({0, 0}, {1, 1}, context), lattice_path({{0, 0}, {1, 1}}));
  EXPECT_EQ(asked, 2);
  EXPECT_EQ(meter.work().evaluations, 2U);
}

}  // namespace
}  // namespace pathrace
