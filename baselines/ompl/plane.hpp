// The map as OMPL sees it: a plane of points, and an inspector who says where they may be and go.
#pragma once

#include <ompl/base/MotionValidator.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>

#include <deque>
#include <memory>
#include <utility>
#include <vector>

#include "baselines/ompl/inspector.hpp"

namespace pathrace::baselines {

/// The rectangle of the map, with the Euclidean distance. Its projection for planners that count samples per
/// cell is the plane itself in squares of one map cell: the library's default for two dimensions is broken in
/// 1.5.2 (it takes a number of bytes for a number of coordinates, and aborts).
class Plane final : public ompl::base::RealVectorStateSpace {
 public:
  explicit Plane(const FreeSpace& space);

  void registerProjections() override;
  double distance(const ompl::base::State* a, const ompl::base::State* b) const override;
  void copyState(ompl::base::State* to, const ompl::base::State* from) const override;
  // States live in the plane: some planners never give theirs back. One thread at a time.
  ompl::base::State* allocState() const override;
  void freeState(ompl::base::State* state) const override;

 private:
  struct PlaneState : StateType {
    double xy[2] = {0, 0};
  };
  mutable std::deque<PlaneState> states_;
  mutable std::vector<ompl::base::State*> free_;
};

inline Point point_of(const ompl::base::State* state) {
  const double* values = state->as<ompl::base::RealVectorStateSpace::StateType>()->values;
  return {values[0], values[1]};
}

inline void place(ompl::base::State* state, Point point) {
  double* values = state->as<ompl::base::RealVectorStateSpace::StateType>()->values;
  values[0] = point.x;
  values[1] = point.y;
}

/// The plane with the inspector's answers. The inspector outlives it.
std::shared_ptr<ompl::base::SpaceInformation> inspected_plane(Inspector& inspector);

/// The inspector behind a plane.
Inspector& inspector_of(const ompl::base::SpaceInformation& plane);

}  // namespace pathrace::baselines
