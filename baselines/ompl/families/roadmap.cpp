// Roadmaps.
#include "baselines/ompl/counted_prm.hpp"
#include "baselines/ompl/counted_spars.hpp"
#include "baselines/ompl/entry.hpp"
#include "baselines/ompl/families.hpp"
#include "baselines/ompl/lazy_prm.hpp"
#include "baselines/ompl/lazy_prm_star.hpp"

namespace pathrace::baselines {

namespace og = ompl::geometric;

std::vector<PlannerCard> ompl_roadmap_cards() {
  return {
#define PATHRACE_OMPL_ROADMAP(name, planner, ...) ompl_card({name, make_ompl_planner<planner>, __VA_ARGS__}),
#include "baselines/ompl/planners.def"
  };
}

}  // namespace pathrace::baselines
