#include "algorithms/algorithms.hpp"

namespace pathrace::algorithms {

#define PATHRACE_PLANNER(card) PlannerCard card();
#include "algorithms/planners.def"
#undef PATHRACE_PLANNER

std::vector<PlannerCard> cards() {
  return {
#define PATHRACE_PLANNER(card) card(),
#include "algorithms/planners.def"
#undef PATHRACE_PLANNER
  };
}

}  // namespace pathrace::algorithms
