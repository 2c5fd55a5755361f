// Searches over batches of samples.
#include "baselines/ompl/ait_star.hpp"
#include "baselines/ompl/entry.hpp"
#include "baselines/ompl/families.hpp"

#include <ompl/geometric/planners/fmt/BFMT.h>
#include <ompl/geometric/planners/fmt/FMT.h>
#include <ompl/geometric/planners/informedtrees/ABITstar.h>
#include <ompl/geometric/planners/informedtrees/BITstar.h>

namespace pathrace::baselines {

namespace og = ompl::geometric;

std::vector<PlannerCard> ompl_batch_cards() {
  return {
#define PATHRACE_OMPL_BATCH(name, planner, ...) ompl_card({name, make_ompl_planner<planner>, __VA_ARGS__}),
#include "baselines/ompl/planners.def"
  };
}

}  // namespace pathrace::baselines
