// Trees that grow from the start, or from both ends, until they reach each other.
#include "baselines/ompl/entry.hpp"
#include "baselines/ompl/families.hpp"

#include <ompl/geometric/planners/est/BiEST.h>
#include <ompl/geometric/planners/est/EST.h>
#include <ompl/geometric/planners/rrt/BiTRRT.h>
#include <ompl/geometric/planners/rrt/LazyRRT.h>
#include <ompl/geometric/planners/rrt/RRT.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/geometric/planners/rrt/TRRT.h>
#include <ompl/geometric/planners/stride/STRIDE.h>

namespace pathrace::baselines {

namespace og = ompl::geometric;

std::vector<PlannerCard> ompl_tree_cards() {
  return {
#define PATHRACE_OMPL_TREE(name, planner, ...) ompl_card({name, make_ompl_planner<planner>, __VA_ARGS__}),
#include "baselines/ompl/planners.def"
  };
}

}  // namespace pathrace::baselines
