// What Tan's colony knows before its first ant walks: circles, their sets, the pre-planned path and the
// initial pheromone along it.
//
// Tan et al., 3.3.1; the parts are in obstacles, connectivity, preplanned_path and gaussian_field.
#pragma once

#include <vector>

#include "algorithms/aco/tan/connectivity.hpp"
#include "algorithms/aco/tan/gaussian_field.hpp"
#include "algorithms/aco/tan/obstacles.hpp"
#include "core/overlay.hpp"
#include "core/planner.hpp"

namespace pathrace::algorithms {

struct Environment {
  std::vector<Circle> circles;
  std::vector<CircleSet> sets;
  std::vector<Point> preplanned;  ///< from start to goal
  std::vector<double> pheromone;  ///< tau0 by padded index
};

Environment environment_of(const Problem& problem, const CoverSettings& cover_settings,
                           const GaussianField& field);

/// Adds circles and pre-planned path to a picture.
void draw(const Environment& environment, Overlay& overlay);

}  // namespace pathrace::algorithms
