// What is measured on a path, whoever planned it.
#pragma once

#include <optional>

#include "core/distance_transform.hpp"
#include "core/lattice_length.hpp"
#include "core/path.hpp"

namespace pathrace {

struct PathMetrics {
  double length = 0;                     ///< in cell edges
  std::optional<LatticeLength> lattice;  ///< exact counts of steps; lattice paths only
  int turns = 0;                         ///< interior points where the direction changes (algorithms.md 0.4)
  double turn_angle = 0;                 ///< sum of the turning angles, radians
  double clearance_min = 0;              ///< least distance to a blocked cell's centre along the path, cells
  double clearance_mean = 0;             ///< mean of that distance over the visited cells
};

/// Expects a non-empty path whose points lie on the map; lattice paths step from cell to neighbouring cell.
PathMetrics measure(const Path& path, const DistanceTransform& clearance);

}  // namespace pathrace
