// Ant Colony System: greedy ants, a trail that they wear off, and only the best so far that deposits.
//
// An ant takes the best step with probability q0, else it draws by eq. (1). Steps that ants have taken move
// towards the initial pheromone, tau := (1 - xi) tau + xi tau0, so that others look elsewhere; then the
// best path so far is reinforced, tau := (1 - evaporation) tau + evaporation Q / C_bs, on its own steps only.
//
// The paper wears the trail off while ants walk. Here walks of an iteration do not see each other: their
// steps, forwards first and then those taken back, are applied at its end in ant order.
//
// M. Dorigo, L. M. Gambardella, "Ant Colony System", IEEE Trans. Evol. Comp. 1(1), 1997.
#include "algorithms/aco/colony.hpp"

namespace pathrace::algorithms {
namespace {

struct AntColonySystemSettings : ColonySettings {
  AntColonySystemSettings() {
    ants = 10;
    beta = 5;
    evaporation = 0.1;
  }
  double q0 = 0.9;
  double xi = 0.1;
};

class AntColonySystem final : public PheromoneRule {
 public:
  explicit AntColonySystem(const AntColonySystemSettings& settings)
      : PheromoneRule(settings), settings_(settings) {}

  /// 1 / (n C_nn), n steps of the greedy walk.
  double initial_pheromone(const Scout& scout) const override {
    return settings_.deposit / (scout.steps * scout.length);
  }
  double q0() const override { return settings_.q0; }
  bool keeps_the_dead() const override { return settings_.xi > 0; }
  bool keeps_popped() const override { return settings_.xi > 0; }

  void begin(Colony& colony) override {
    PheromoneRule::begin(colony);
    initial_ = colony.trail().pheromone(colony.nest().start(), 0);
  }

  // Every ant wears off the trail that it walked on.
  Imprint imprint() const override {
    return {.persistence = 1, .factor = 1 - settings_.xi, .of_the_dead = true, .on_popped = true};
  }
  double amount(const Walk& /*walk*/) const override { return settings_.xi * initial_; }
  Early deposits_early() const override { return settings_.xi > 0 ? Early::yes : Early::no; }

  void learn(Colony& colony, const Harvest& harvest) override {
    if (settings_.xi > 0) colony.imprint(harvest.count);
    const Walk& best = colony.best();
    if (!best.arrived) return;
    const double rho = settings_.evaporation;
    colony.change(best, 1 - rho, rho * (settings_.deposit / best.length.value()));
  }

 private:
  const AntColonySystemSettings& settings_;
  double initial_ = 0;
};

}  // namespace

PlannerCard ant_colony_system_card() {
  using S = AntColonySystemSettings;
  PlannerCard card;
  card.name = "acs";
  card.summary = "Ant Colony System: greedy ants wear the trail off, the best so far renews it";
  card.source = "M. Dorigo, L. M. Gambardella, IEEE Trans. Evol. Comp. 1(1), 1997";
  card.default_budget.iterations = 500;
  return colony_card<S, AntColonySystem>(
      std::move(card), colony_schema<S>({
                           real("q0", &S::q0, 0, 1, "", Source::seen,
                                "chance of the best step; ties among the best are broken uniformly"),
                           real("xi", &S::xi, 0, 1, "", Source::literature,
                                "how far a step that an ant took goes back to the initial pheromone"),
                       }));
}

}  // namespace pathrace::algorithms
