// From plans on a grid to the robot's next step: what navigators that plan on maps have in common.
//
// Discs grow by the robot's radius and by `margin` cells: from 0.75 cells on, a path from cell to cell cannot
// cut a disc. The robot drives towards the farthest point of the path that it can see. Where nothing is
// found, discs grow by the radius alone; where still nothing is found, the robot waits, and steps aside when
// a disc comes near.
//
// The way chosen last is kept while it is clear of discs all along and the new plan is not shorter. Without
// this the robot may swing for ever where the maps with and without the margin lead to opposite sides. Among
// discs and a goal that stand still, what is left of a kept way shrinks with every step and only a shorter
// one replaces it. To demand that the new way be shorter by one or two steps made no difference to which of
// 700 worlds are solved. Not helped: a gap so narrow that a path of the map without the margin cuts its
// discs, before which the robot may step to and fro.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "baselines/navigators/disc_map.hpp"
#include "core/planner.hpp"

namespace pathrace::baselines {

/// A path on this map from the robot's cell to the goal's. `attempt` is 0 on the map with the margin, 1 on
/// the map without. Spends its own work at the meter.
using PlanOnMap = std::function<Answer(const DiscMap& map, std::size_t attempt)>;

/// Steers one run.
class Steering {
 public:
  /// `resolution`, the edge of a cell, in units; `margin` in cells.
  Steering(double resolution, double margin) : resolution_(resolution), margin_(margin) {}

  /// The robot's next position. A disc looked at, on the map or beside a way, is one check.
  Point next(const Snapshot& snapshot, Meter& meter, const PlanOnMap& plan);

 private:
  struct Course {
    std::vector<Point> way;  // from the point driven towards to the goal
    Point step;              // the next position
    double length = 0;       // from the robot along the way
  };

  static std::optional<Course> course_along(std::vector<Point> way, const Snapshot& snapshot, Meter& meter);
  std::optional<Course> kept(const Snapshot& snapshot, Meter& meter) const;
  std::optional<Course> planned(const Snapshot& snapshot, Meter& meter, const PlanOnMap& plan) const;

  double resolution_;
  double margin_;
  std::vector<Point> way_;
};

}  // namespace pathrace::baselines
