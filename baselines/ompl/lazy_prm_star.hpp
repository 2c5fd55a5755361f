// LazyPRM* that tells of each improvement: the library keeps its best path to itself until the end.
#pragma once

#include <ompl/geometric/planners/prm/LazyPRMstar.h>

namespace pathrace::baselines {

class ReportingLazyPrmStar final : public ompl::geometric::LazyPRMstar {
 public:
  using ompl::geometric::LazyPRMstar::LazyPRMstar;

  ompl::base::PlannerStatus solve(const ompl::base::PlannerTerminationCondition& stop) override {
    return LazyPRMstar::solve(ompl::base::PlannerTerminationCondition([&] {
      const auto& tell = pdef_->getIntermediateSolutionCallback();
      if (tell) tell(this, {}, bestCost_);
      return stop();
    }));
  }
};

}  // namespace pathrace::baselines
