// LazyPRM whose `max_nearest_neighbors` counts.
//
// The library ties neighbours to the planner's range, too, and takes it before setup() has settled it: within
// a range of 0 no point has a neighbour, and the roadmap grows for ever without an edge.
#pragma once

#include <ompl/geometric/planners/prm/ConnectionStrategy.h>
#include <ompl/geometric/planners/prm/LazyPRM.h>

namespace pathrace::baselines {

class LazyPrm final : public ompl::geometric::LazyPRM {
 public:
  explicit LazyPrm(const ompl::base::SpaceInformationPtr& si) : ompl::geometric::LazyPRM(si) {
    params_.remove("max_nearest_neighbors");
    declareParam<unsigned>("max_nearest_neighbors", this, &LazyPrm::set_most_neighbours,
                           &LazyPrm::most_neighbours, "0:1000");
  }

  void setup() override {
    ompl::geometric::LazyPRM::setup();
    if (most_neighbours_ == 0) return;  // the library's number
    connectionStrategy_ = ompl::geometric::KBoundedStrategy<Vertex>(most_neighbours_, maxDistance_, nn_);
  }

 private:
  void set_most_neighbours(unsigned count) { most_neighbours_ = count; }
  unsigned most_neighbours() const { return most_neighbours_; }

  unsigned most_neighbours_ = 0;
};

}  // namespace pathrace::baselines
