// Rank-based Ant System: only the best ants of an iteration deposit, by their rank, and the best so far most.
//
// tau := (1 - evaporation) tau + sum over r = 1..w-1 of (w - r) Q / C_r + w Q / C_bs, where C_r is the length
// of the r-th best walk of the iteration. Of walks of equal length the lower index ranks first.
//
// B. Bullnheimer, R. F. Hartl, C. Strauss, "A new rank based version of the Ant System", CEJOR 7(1), 1999.
#include <algorithm>

#include "algorithms/aco/colony.hpp"

namespace pathrace::algorithms {
namespace {

struct RankSettings : ColonySettings {
  RankSettings() {
    beta = 5;
    evaporation = 0.1;
  }
  int ranks = 6;
};

class RankBasedAntSystem final : public PheromoneRule {
 public:
  explicit RankBasedAntSystem(const RankSettings& settings)
      : PheromoneRule(settings), ranks_(settings.ranks) {}

  /// 0.5 w (w - 1) / (evaporation C_nn); half the weight of one rank when w = 1 leaves none.
  double initial_pheromone(const Scout& scout) const override {
    return 0.5 * std::max(1, ranks_ * (ranks_ - 1)) * settled(scout.length);
  }

  void learn(Colony& colony, const Harvest& harvest) override {
    colony.trail().evaporate(1 - settings().evaporation);
    rank(colony, harvest.count);
    for (std::size_t r = 1; r < static_cast<std::size_t>(ranks_) && r <= ranking_.size(); ++r) {
      const Walk& walk = colony.walks()[ranking_[r - 1]];
      colony.deposit(walk, (ranks_ - static_cast<double>(r)) * amount(walk));
    }
    if (colony.best().arrived) colony.deposit(colony.best(), ranks_ * amount(colony.best()));
  }

 private:
  // The ants that deposit, best first.
  void rank(const Colony& colony, std::size_t count) {
    ranking_.clear();
    for (std::size_t k = 0; k < count; ++k) {
      if (colony.walks()[k].arrived) ranking_.push_back(k);
    }
    const std::size_t wanted = std::min(ranking_.size(), static_cast<std::size_t>(ranks_ - 1));
    const auto end = ranking_.begin() + static_cast<std::ptrdiff_t>(wanted);
    std::partial_sort(ranking_.begin(), end, ranking_.end(), [&](std::size_t a, std::size_t b) {
      const LatticeLength length_a = colony.walks()[a].length;
      const LatticeLength length_b = colony.walks()[b].length;
      return length_a == length_b ? a < b : length_a < length_b;
    });
  }

  int ranks_;
  std::vector<std::size_t> ranking_;
};

}  // namespace

PlannerCard rank_based_ant_system_card() {
  using S = RankSettings;
  PlannerCard card;
  card.name = "as-rank";
  card.summary = "Rank-based Ant System: the best ants of an iteration reinforce by rank";
  card.source = "B. Bullnheimer, R. F. Hartl, C. Strauss, CEJOR 7(1), 1999";
  card.default_budget.iterations = 100;
  return colony_card<S, RankBasedAntSystem>(
      std::move(card), colony_schema<S>({
                           integer("ranks", &S::ranks, 1, 1000, "ants", Source::seen,
                                   "w: w - 1 ants of the iteration and the best so far reinforce"),
                       }));
}

}  // namespace pathrace::algorithms
