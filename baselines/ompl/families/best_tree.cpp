// Trees that go on improving their path.
#include "baselines/ompl/entry.hpp"
#include "baselines/ompl/families.hpp"
#include "baselines/ompl/lbt_rrt.hpp"

#include <ompl/geometric/planners/rrt/InformedRRTstar.h>
#include <ompl/geometric/planners/rrt/RRTXstatic.h>
#include <ompl/geometric/planners/rrt/RRTsharp.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>
#include <ompl/geometric/planners/rrt/SORRTstar.h>
#include <ompl/geometric/planners/sst/SST.h>

namespace pathrace::baselines {

namespace og = ompl::geometric;

std::vector<PlannerCard> ompl_best_tree_cards() {
  return {
#define PATHRACE_OMPL_BEST_TREE(name, planner, ...) \
  ompl_card({name, make_ompl_planner<planner>, __VA_ARGS__}),
#include "baselines/ompl/planners.def"
  };
}

}  // namespace pathrace::baselines
