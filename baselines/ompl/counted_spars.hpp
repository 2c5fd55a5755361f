// SPARS2 in one thread: the library lets a second thread look for a path by the clock; here the roadmap is
// looked at each `calls_between_looks` times that its loop asks whether to stop.
#pragma once

#include <ompl/base/goals/GoalSampleableRegion.h>
#include <ompl/geometric/planners/prm/SPARStwo.h>

#include "baselines/ompl/plane.hpp"

namespace pathrace::baselines {

class CountedSpars2 final : public ompl::geometric::SPARStwo {
 public:
  using ompl::geometric::SPARStwo::SPARStwo;

  ompl::base::PlannerStatus solve(const ompl::base::PlannerTerminationCondition& stop) override {
    using ompl::base::PlannerStatus;
    checkValidity();
    checkQueryStateInitialization();
    if (!insert_ends()) return PlannerStatus::INVALID_START;
    if (!sampler_) sampler_ = si_->allocValidStateSampler();
    ompl::base::PathPtr path;
    unsigned calls = 0;
    constructRoadmap(ompl::base::PlannerTerminationCondition([&] {
      const bool look = calls++ % calls_between_looks == 0;
      const bool done = path || (look && haveSolution(startM_, goalM_, path)) || reachedFailureLimit();
      if (done) inspector_of(*si_).close();
      return done || stop();
    }));
    if (!path && !haveSolution(startM_, goalM_, path)) return PlannerStatus::TIMEOUT;
    pdef_->addSolutionPath(path, false, -1.0, getName());
    return PlannerStatus::EXACT_SOLUTION;
  }

 private:
  static constexpr unsigned calls_between_looks = 40;

  bool insert_ends() {
    while (const ompl::base::State* state = pis_.nextStart()) {
      startM_.push_back(addGuard(si_->cloneState(state), START));
    }
    while (const ompl::base::State* state = pis_.nextGoal()) {
      goalM_.push_back(addGuard(si_->cloneState(state), GOAL));
    }
    return !startM_.empty() && !goalM_.empty();
  }
};

}  // namespace pathrace::baselines
