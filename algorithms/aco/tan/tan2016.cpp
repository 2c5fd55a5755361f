// An ant colony with a pre-planned path, a price on turns and a table of dead ends.
//
// Ant System with three changes:
//   1. The trail does not start even: a Gaussian ridge leads along a path planned from obstacle to obstacle.
//   2. An ant of length L with G turns adds Q / (L + phi G) to its steps (5).
//   3. An ant that is stuck steps back. The cells it leaves go to a table that is closed to all ants, and the
//      steps it takes back lose pheromone: tau := mu tau (6).
//
// Tan Tan, Liu Shudong, Zhang Yan, "Simulation Study of Path Planning Method for Mobile Robot", Computer
// Simulation, 2016; algorithms.md 2. The paper prints no parameter values.
//
// The paper closes cells and lowers pheromone at once; here both are collected and applied at the iteration's
// end, in ant order, before evaporation. `dead_table = global_literal` is the table as published, which can
// cut the best way off. With amplitude 0, phi 0, mu 1 and no table this is `as`, bit for bit.
#include "algorithms/aco/tan/tan2016.hpp"

#include <algorithm>

#include "algorithms/aco/colony.hpp"
#include "algorithms/aco/dead_ends.hpp"
#include "core/checkpoint.hpp"

namespace pathrace::algorithms {
namespace {

using S = Tan2016Settings;

Schema<S> schema() {
  return colony_schema<S>({
      real("amplitude", &S::amplitude, 0, 1000, "initial pheromone", Source::inferred,
           "A, height of the ridge along the pre-planned path; 0 is an even start"),
      real("sigma", &S::sigma, 0.01, 1000, "cells", Source::inferred,
           "half width of the ridge, which is cut at three sigma"),
      choice("step_value", &S::step_value, Source::inferred,
             "initial pheromone of a step: that of its target, or the mean of its ends"),
      choice("neighbours", &S::neighbours, Source::inferred, "which blocked cells are one obstacle"),
      real("area_ratio", &S::area_ratio, 0, 1e9, "", Source::inferred,
           "an obstacle is halved while its circle has more than so many times its area"),
      integer("max_depth", &S::max_depth, 0, 30, "halvings", Source::inferred, "at most so many in a row"),
      real("phi", &S::phi, 0, 1000, "cells / turn", Source::inferred,
           "length that a turn counts for in eq. (5)"),
      choice(
          "dead_table", &S::dead_table, Source::inferred,
          "what becomes of cells that ants stepped back from (dead_end = backtrack): none, per_ant: nothing "
          "beyond the ant's own list; global_literal: closed to all, as published; global_dominated: closed "
          "if no shortest way can need them"),
      real("mu", &S::mu, 0, 1, "", Source::inferred, "eq. (6): share of pheromone left on a step taken back"),
      real("penalty_floor", &S::penalty_floor, 0, 1, "initial pheromone", Source::inferred,
           "eq. (6) lowers no step below this"),
  });
}

class Tan2016 final : public PheromoneRule {
 public:
  Tan2016(const S& settings, const Problem& problem)
      : PheromoneRule(settings),
        settings_(settings),
        problem_(problem),
        dead_ends_(problem, settings.dead_table, DeadCells::Layer::dead) {}

  double initial_pheromone(const Scout& scout) const override { return settings_.ants / scout.length; }
  bool keeps_popped() const override { return settings_.mu < 1 || dead_ends_.global(); }
  bool counts_turns() const override { return settings_.phi > 0; }

  void begin(Colony& colony) override {
    PheromoneRule::begin(colony);
    const Nest& nest = colony.nest();
    even_ = colony.trail().pheromone(nest.start(), 0);
    environment_ = environment_of(problem_, settings_.cover(), settings_.field(even_));
    const std::vector<double>& tau0 = environment_.pheromone;
    Pace pace;
    for (std::size_t index = 0; index < nest.size(); ++index) {
      pace.step();
      for (int d = 0; d < direction_count; ++d) {
        if ((nest.moves()[index] >> d & 1) == 0) continue;
        const double target = tau0[nest.moves().step(index, d)];
        colony.trail().set(index, d, step_value(settings_.step_value, tau0[index], target));
      }
    }
  }

  double amount(const Walk& walk) const override {
    return settings_.deposit / (walk.length.value() + settings_.phi * walk.turns);
  }

  // Where turns have a price: of equal lengths the one with fewer turns, then the first in the order of
  // steps.
  bool better(const Walk& challenger, const Walk& incumbent) const override {
    if (challenger.length != incumbent.length || settings_.phi == 0)
      return challenger.length < incumbent.length;
    if (challenger.turns != incumbent.turns) return challenger.turns < incumbent.turns;
    return challenger.directions < incumbent.directions;
  }

  void draw(Overlay& overlay) const override { algorithms::draw(environment_, overlay); }

  // A penalty comes before the deposits; closing cells leaves pheromone as it is.
  Early deposits_early() const override { return settings_.mu < 1 ? Early::until_a_step_back : Early::yes; }

  void learn(Colony& colony, const Harvest& harvest) override {
    if (settings_.mu < 1) penalise(colony, harvest.count);
    dead_ends_.mark(colony, harvest.count);
    colony.imprint(harvest.count);
  }

 private:
  void penalise(Colony& colony, std::size_t count) const {
    for (std::size_t k = 0; k < count; ++k) {
      for (const Step& step : colony.walks()[k].popped) {
        weaken(colony.trail(), step.index, step.direction);
        weaken(colony.trail(), colony.nest().moves().step(step.index, step.direction),
               opposite(step.direction));
      }
    }
  }

  void weaken(Trail& trail, std::size_t index, int direction) const {
    const double tau = trail.pheromone(index, direction);
    const double floor = std::min(tau, settings_.penalty_floor * even_);
    trail.set(index, direction, std::max(settings_.mu * tau, floor));
  }

  const S& settings_;
  const Problem& problem_;
  DeadEnds dead_ends_;
  Environment environment_;
  double even_ = 0;  // C
};

}  // namespace

PlannerCard tan2016_card() {
  PlannerCard card;
  card.name = "tan2016";
  card.version = 2;
  card.summary = "Ant System with a pre-planned path, a price on turns and a table of dead ends";
  card.source = "Tan T., Liu S., Zhang Y., Computer Simulation 2016, eq. (4)-(6); parameter values inferred";
  card.default_budget.iterations = 100;
  return colony_card<S, Tan2016>(std::move(card), schema());
}

}  // namespace pathrace::algorithms
