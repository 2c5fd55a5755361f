#include "baselines/baselines.hpp"

namespace pathrace::baselines {

#define PATHRACE_PLANNER(card) PlannerCard card();
#include "baselines/planners.def"
#undef PATHRACE_PLANNER

std::vector<PlannerCard> cards() {
  return {
#define PATHRACE_PLANNER(card) card(),
#include "baselines/planners.def"
#undef PATHRACE_PLANNER
  };
}

}  // namespace pathrace::baselines
