// MAX-MIN Ant System: one ant deposits, and pheromone stays between limits.
//
// tau := (1 - evaporation) tau + Q / C on the path of one ant: mostly the iteration's best, every
// `best_so_far_every` iterations the best so far. tau starts at its upper limit, and both limits follow the
// best so far. When nothing has improved for `restart_after` iterations and the trail along the best path has
// converged, every tau goes back to the upper limit.
//
// T. Stuetzle, H. H. Hoos, "MAX-MIN Ant System", Future Generation Computer Systems 16(8), 2000; what becomes
// of n, avg and the branching factor on a grid is in max_min_limits.hpp.
#include "algorithms/aco/colony.hpp"
#include "algorithms/aco/max_min_limits.hpp"

namespace pathrace::algorithms {
namespace {

struct MaxMinSettings : ColonySettings {
  MaxMinSettings() {
    beta = 5;
    evaporation = 0.02;
  }
  double p_best = 0.05;
  double choices = 0;
  int best_so_far_every = 25;
  int restart_after = 250;
  double branching_lambda = 0.05;
  double branching_limit = 1.00001;
};

class MaxMinAntSystem final : public PheromoneRule {
 public:
  explicit MaxMinAntSystem(const MaxMinSettings& settings) : PheromoneRule(settings), settings_(settings) {}

  /// tau_max of the greedy walk, 1 / (evaporation C_nn).
  double initial_pheromone(const Scout& scout) const override {
    return settings_.deposit * settled(scout.length);
  }

  /// Until there is a best path, tau stays below where it starts.
  void begin(Colony& colony) override {
    choices_ = settings_.choices > 0 ? settings_.choices : mean_choices(colony.nest());
    const double start = colony.trail().pheromone(colony.nest().start(), 0);
    colony.trail().limit(0, start);
  }

  void learn(Colony& colony, const Harvest& harvest) override {
    if (harvest.improved) set_limits(colony);
    stale_ = harvest.improved ? 0 : stale_ + 1;
    colony.trail().evaporate(1 - settings_.evaporation);
    if (const Walk* walk = chosen(colony, harvest)) colony.deposit(*walk, amount(*walk));
    if (stale_ > settings_.restart_after && converged(colony)) {
      colony.trail().reset(colony.trail().upper_limit());
      stale_ = 0;
    }
  }

 private:
  void set_limits(Colony& colony) const {
    const double upper = settings_.deposit * settled(colony.best().length.value());
    const auto steps = static_cast<double>(colony.best().directions.size());
    colony.trail().limit(upper * least_share(settings_.p_best, steps, choices_), upper);
  }

  const Walk* chosen(const Colony& colony, const Harvest& harvest) const {
    const auto every = static_cast<std::uint64_t>(settings_.best_so_far_every);
    const bool best_so_far = every > 0 && (harvest.iteration + 1) % every == 0;
    return best_so_far && colony.best().arrived ? &colony.best() : harvest.shortest;
  }

  bool converged(const Colony& colony) const {
    return colony.best().arrived &&
           mean_branching(colony.nest(), colony.trail(), colony.best(), settings_.branching_lambda,
                          settings_.both_ways) < settings_.branching_limit;
  }

  const MaxMinSettings& settings_;
  double choices_ = 0;
  int stale_ = 0;
};

}  // namespace

PlannerCard max_min_ant_system_card() {
  using S = MaxMinSettings;
  PlannerCard card;
  card.name = "mmas";
  card.summary = "MAX-MIN Ant System: one ant reinforces, pheromone stays between limits";
  card.source = "T. Stuetzle, H. H. Hoos, Future Generation Computer Systems 16(8), 2000";
  card.default_budget.iterations = 100;
  return colony_card<S, MaxMinAntSystem>(
      std::move(card),
      colony_schema<S>({
          real("p_best", &S::p_best, 1e-6, 0.999, "", Source::literature,
               "chance of the best path once the trail has converged; sets the lower limit"),
          real("choices", &S::choices, 0, 8, "steps", Source::inferred,
               "avg, open choices of an ant at a cell; 0: half the map's mean number of legal steps"),
          integer("best_so_far_every", &S::best_so_far_every, 0, 1'000'000, "iterations", Source::seen,
                  "u_gb: how often the best so far deposits, not the iteration's best; 0: never"),
          integer("restart_after", &S::restart_after, 0, 1'000'000'000, "iterations", Source::literature,
                  "without an improvement, before a converged trail starts afresh"),
          real("branching_lambda", &S::branching_lambda, 0, 1, "", Source::literature,
               "a step counts as a branch above this share of its cell's range of tau"),
          real("branching_limit", &S::branching_limit, 0, 8, "", Source::literature,
               "the trail has converged below this mean number of branches"),
      }));
}

}  // namespace pathrace::algorithms
