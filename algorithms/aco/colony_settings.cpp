#include "algorithms/aco/colony_settings.hpp"

namespace pathrace::algorithms {

const std::vector<Field<ColonySettings>>& colony_fields() {
  using S = ColonySettings;
  static const std::vector<Field<S>> fields = {
      integer("ants", &S::ants, 1, 100000, "ants", Source::seen, "m, walks per iteration"),
      real("alpha", &S::alpha, 0, 20, "", Source::seen,
           "weight of the pheromone in eq. (1); 0 learns nothing"),
      real("beta", &S::beta, 0, 50, "", Source::seen, "weight of the heuristic in eq. (1)"),
      real("evaporation", &S::evaporation, 0, 1, "", Source::seen,
           "share of the pheromone lost per iteration; where a paper's rho is the share kept, 1 - rho"),
      real("deposit", &S::deposit, 0, 1e9, "pheromone * cells", Source::seen,
           "Q of eq. (3): an ant adds Q / length"),
      real("initial_pheromone", &S::initial_pheromone, 0, 1e9, "pheromone", Source::seen,
           "tau at the start; 0: the variant's own formula, from the length of a greedy walk with "
           "backtracking"),
      real("pheromone_floor", &S::pheromone_floor, 0, 1, "pheromone", Source::inferred,
           "tau never falls below this, so that no step is lost for ever"),
      real("goal_attraction", &S::goal_attraction, 1e-6, 1e9, "1 / cells", Source::seen,
           "heuristic value of a step onto the goal itself, where 1 / distance is infinite"),
      boolean("both_ways", &S::both_ways, Source::seen, "deposit on a step and on its reverse"),
      choice("heuristic", &S::heuristic, Source::seen,
             "inv_goal: 1 / distance of the next cell to the goal; inv_step: 1 / length of the step, the "
             "paper's text"),
      choice("dead_end", &S::dead_end, Source::seen, "what an ant does when all its neighbours are tabu"),
      choice("answer", &S::answer, Source::paper,
             "best_so_far, or argmax_pheromone: the walk along the strongest trail, as the paper ends"),
      integer("max_steps", &S::max_steps, 0, 1'000'000'000'000, "decisions", Source::ours,
              "a walk gives up after so many decisions; 0: twenty times the free cells"),
  };
  return fields;
}

}  // namespace pathrace::algorithms
