// LBT-RRT with a defined start.
//
// The library never sets the lower-bound cost of the start's motion, so that a run depends on what the heap
// held before. Here the start is inserted with cost 0 before the search begins. It tells of no improvement
// either; the best path is looked up each time it asks whether to stop.
#pragma once

#include <ompl/geometric/planners/rrt/LBTRRT.h>

#include <cstddef>

namespace pathrace::baselines {

class LbtRrt final : public ompl::geometric::LBTRRT {
 public:
  using ompl::geometric::LBTRRT::LBTRRT;

  ompl::base::PlannerStatus solve(const ompl::base::PlannerTerminationCondition& stop) override {
    checkValidity();
    while (const ompl::base::State* state = pis_.nextStart()) insert_start(state);
    return LBTRRT::solve(ompl::base::PlannerTerminationCondition([&] {
      report();
      return stop();
    }));
  }

 private:
  void insert_start(const ompl::base::State* state) {
    auto* const motion = new Motion(si_);
    si_->copyState(motion->state_, state);
    motion->costLb_ = 0;
    motion->id_ = nn_->size();
    idToMotionMap_.push_back(motion);
    nn_->add(motion);
    lowerBoundGraph_.addVertex(motion->id_);
  }

  void report() {
    const auto& tell = pdef_->getIntermediateSolutionCallback();
    if (tell && lastGoalMotion_ != nullptr) tell(this, {}, ompl::base::Cost(lastGoalMotion_->costApx_));
  }
};

}  // namespace pathrace::baselines
