// Trees that choose where to grow by how crowded the cells of a projection are.
#include "baselines/ompl/entry.hpp"
#include "baselines/ompl/families.hpp"

#include <ompl/geometric/planners/kpiece/BKPIECE1.h>
#include <ompl/geometric/planners/kpiece/KPIECE1.h>
#include <ompl/geometric/planners/kpiece/LBKPIECE1.h>
#include <ompl/geometric/planners/pdst/PDST.h>
#include <ompl/geometric/planners/sbl/SBL.h>

namespace pathrace::baselines {

namespace og = ompl::geometric;

std::vector<PlannerCard> ompl_cell_cards() {
  return {
#define PATHRACE_OMPL_CELL(name, planner, ...) ompl_card({name, make_ompl_planner<planner>, __VA_ARGS__}),
#include "baselines/ompl/planners.def"
  };
}

}  // namespace pathrace::baselines
