// PRM and PRM* in one thread, on a counted schedule.
//
// The library lets a second thread look for a path every millisecond, and grows and expands the roadmap by
// the clock. Here a round grows it for `grow_calls` questions of the loop whether to stop, expands it for
// half as many (L. Kavraki et al. use two to one), and then looks for a path: each time the start's and the
// goal's components meet. PRM* goes on and looks again whenever the roadmap has grown by a tenth.
#pragma once

#include <ompl/base/goals/GoalSampleableRegion.h>
#include <ompl/geometric/planners/prm/PRM.h>

#include <algorithm>
#include <vector>

namespace pathrace::baselines {

class CountedPrm : public ompl::geometric::PRM {
 public:
  explicit CountedPrm(const ompl::base::SpaceInformationPtr& si, bool star = false)
      : ompl::geometric::PRM(si, star) {
    if (star) {
      setName("PRMstar");
      params_.remove("max_nearest_neighbors");
    }
  }

  ompl::base::PlannerStatus solve(const ompl::base::PlannerTerminationCondition& stop) override {
    using ompl::base::PlannerStatus;
    checkValidity();
    if (!insert_ends()) return PlannerStatus::INVALID_START;
    allocate_samplers();
    std::vector<ompl::base::State*> work(bounce_steps);
    si_->allocStates(work);
    ompl::base::PathPtr best;
    bool satisfied = look_for_path(best);
    unsigned calls = grow_calls;
    while (!satisfied && !stop()) {
      growRoadmap(counted(stop, calls), work[0]);
      expandRoadmap(counted(stop, calls / 2), work);
      satisfied = look_for_path(best);
      if (starStrategy_ && best) calls = std::max(grow_calls, static_cast<unsigned>(milestoneCount() / 10));
    }
    si_->freeStates(work);
    if (!best) return PlannerStatus::TIMEOUT;
    pdef_->addSolutionPath(best, false, -1.0, getName());
    return PlannerStatus::EXACT_SOLUTION;
  }

 private:
  static constexpr unsigned grow_calls = 40;
  static constexpr unsigned bounce_steps = 5;  // the library's ompl::magic::MAX_RANDOM_BOUNCE_STEPS

  static ompl::base::PlannerTerminationCondition counted(const ompl::base::PlannerTerminationCondition& stop,
                                                         unsigned calls) {
    return ompl::base::PlannerTerminationCondition(
        [&stop, calls]() mutable { return calls == 0 || (--calls, stop()); });
  }

  bool insert_ends() {
    while (const ompl::base::State* state = pis_.nextStart()) {
      startM_.push_back(addMilestone(si_->cloneState(state)));
    }
    while (const ompl::base::State* state = pis_.nextGoal()) {
      goalM_.push_back(addMilestone(si_->cloneState(state)));
    }
    return !startM_.empty() && !goalM_.empty();
  }

  void allocate_samplers() {
    if (!sampler_) sampler_ = si_->allocValidStateSampler();
    if (!simpleSampler_) simpleSampler_ = si_->allocStateSampler();
  }

  // True when the path is good enough. The roadmap only grows, so a later path is no longer than this.
  bool look_for_path(ompl::base::PathPtr& best) {
    ompl::base::PathPtr found;
    const bool satisfied = maybeConstructSolution(startM_, goalM_, found);
    if (!found) return false;
    const auto& tell = pdef_->getIntermediateSolutionCallback();
    if (tell) tell(this, {}, ompl::base::Cost(found->length()));
    best = found;
    return satisfied;
  }
};

class CountedPrmStar final : public CountedPrm {
 public:
  explicit CountedPrmStar(const ompl::base::SpaceInformationPtr& si) : CountedPrm(si, true) {}
};

}  // namespace pathrace::baselines
