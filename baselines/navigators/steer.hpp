// From plans on a grid to the robot's next step: what navigators that plan on maps have in common.
//
// Discs grow by the robot's radius and by `margin` cells: from 0.75 cells on, a path from cell to cell cannot
// cut a disc. The robot drives towards the farthest point of the path that it can see. Where nothing is
// found, discs grow by the radius alone; where still nothing is found, the robot waits, and steps aside when
// a disc comes near.
#pragma once

#include <cstddef>
#include <functional>

#include "baselines/navigators/disc_map.hpp"
#include "core/planner.hpp"

namespace pathrace::baselines {

/// A path on this map from the robot's cell to the goal's. `attempt` is 0 on the map with the margin, 1 on
/// the map without. Spends its own work at the meter.
using PlanOnMap = std::function<Answer(const DiscMap& map, std::size_t attempt)>;

/// The robot's next position. A disc looked at, on the map or beside the way, is one check. `resolution` in
/// units, `margin` in cells.
Point steer(const Snapshot& snapshot, double resolution, double margin, Meter& meter, const PlanOnMap& plan);

}  // namespace pathrace::baselines
