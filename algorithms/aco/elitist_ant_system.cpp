// Elitist Ant System: Ant System in which the best path so far is walked by `elite` further ants.
//
// tau := (1 - evaporation) tau + sum of Q / C_k over the ants that arrived + e Q / C_bs on the best so far.
// With elite = 0 it is Ant System, bit for bit.
//
// M. Dorigo, V. Maniezzo, A. Colorni, 1996; M. Dorigo, T. Stuetzle, "Ant Colony Optimization", MIT Press,
// 2004, section 3.3.2.
#include "algorithms/aco/colony.hpp"

namespace pathrace::algorithms {
namespace {

struct ElitistSettings : ColonySettings {
  ElitistSettings() {
    beta = 5;
    evaporation = 0.5;
  }
  double elite = 50;
};

class ElitistAntSystem final : public PheromoneRule {
 public:
  explicit ElitistAntSystem(const ElitistSettings& settings)
      : PheromoneRule(settings), elite_(settings.elite) {}

  /// (e + m) / (evaporation C_nn).
  double initial_pheromone(const Scout& scout) const override {
    return (elite_ + settings().ants) * settled(scout.length);
  }

  Early deposits_early() const override { return Early::yes; }

  void learn(Colony& colony, const Harvest& harvest) override {
    colony.imprint(harvest.count);
    if (elite_ > 0 && colony.best().arrived) colony.deposit(colony.best(), elite_ * amount(colony.best()));
  }

 private:
  double elite_;
};

}  // namespace

PlannerCard elitist_ant_system_card() {
  using S = ElitistSettings;
  PlannerCard card;
  card.name = "eas";
  card.summary = "Elitist Ant System: the best path so far is reinforced in every iteration";
  card.source = "M. Dorigo, T. Stuetzle, Ant Colony Optimization, MIT Press, 2004, sec. 3.3.2";
  card.default_budget.iterations = 100;
  return colony_card<S, ElitistAntSystem>(
      std::move(card), colony_schema<S>({
                           real("elite", &S::elite, 0, 1e6, "ants", Source::seen,
                                "e, weight of the best path so far; as many as ants by default"),
                       }));
}

}  // namespace pathrace::algorithms
