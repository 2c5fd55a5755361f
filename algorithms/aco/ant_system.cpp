// Ant System on a grid.
//
// Each ant walks from the start, choosing the next cell with probability proportional to
// pheromone^alpha * heuristic^beta among the neighbours it has not visited (1). When all ants of an iteration
// have walked, every trail keeps the share (1 - evaporation) of its pheromone (2), and each ant that arrived
// adds Q / length to the steps it took (3).
//
// M. Dorigo, V. Maniezzo, A. Colorni, "Ant System: Optimization by a Colony of Cooperating Agents", IEEE
// Trans. SMC-B 26(1), 1996; as the "traditional ant colony" of Tan et al., eq. (1) to (3).
#include "algorithms/aco/colony.hpp"

namespace pathrace::algorithms {
namespace {

struct AntSystemSettings : ColonySettings {
  AntSystemSettings() { initial_pheromone = 8; }
};

class AntSystem final : public PheromoneRule {
 public:
  explicit AntSystem(const AntSystemSettings& settings) : PheromoneRule(settings) {}

  /// m / C_nn (Dorigo, Stuetzle, "Ant Colony Optimization", 2004).
  double initial_pheromone(const Scout& scout) const override { return settings().ants / scout.length; }

  Early deposits_early() const override { return Early::yes; }

  void learn(Colony& colony, const Harvest& harvest) override { colony.imprint(harvest.count); }
};

}  // namespace

PlannerCard ant_system_card() {
  PlannerCard card;
  card.name = "as";
  card.version = 2;
  card.summary = "Ant System: all ants that arrive reinforce the steps they took";
  card.source = "M. Dorigo, V. Maniezzo, A. Colorni, IEEE Trans. SMC-B 26(1), 1996; Tan et al., eq. (1)-(3)";
  card.default_budget.iterations = 100;
  return colony_card<AntSystemSettings, AntSystem>(std::move(card), colony_schema<AntSystemSettings>());
}

}  // namespace pathrace::algorithms
