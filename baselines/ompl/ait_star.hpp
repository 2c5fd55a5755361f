// AIT* that tells of each improvement: the library adds every better path to the problem and calls nobody.
#pragma once

#include <ompl/geometric/planners/informedtrees/AITstar.h>

#include <cstddef>

namespace pathrace::baselines {

class ReportingAitStar final : public ompl::geometric::AITstar {
 public:
  using ompl::geometric::AITstar::AITstar;

  ompl::base::PlannerStatus solve(const ompl::base::PlannerTerminationCondition& stop) override {
    return AITstar::solve(ompl::base::PlannerTerminationCondition([&] {
      report();
      return stop();
    }));
  }

 private:
  void report() {
    const std::size_t found = pdef_->getSolutionCount();
    if (found == reported_) return;
    reported_ = found;
    const auto& tell = pdef_->getIntermediateSolutionCallback();
    if (tell && pdef_->hasExactSolution())
      tell(this, {}, ompl::base::Cost(pdef_->getSolutionPath()->length()));
  }

  std::size_t reported_ = 0;
};

}  // namespace pathrace::baselines
