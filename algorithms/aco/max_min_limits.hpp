// The limits of MAX-MIN Ant System, on a grid.
//
// T. Stuetzle, H. H. Hoos, "MAX-MIN Ant System", Future Generation Computer Systems 16(8), 2000, for the
// travelling salesman: tau_max = 1 / (evaporation C_bs), tau_min = tau_max (1 - root) / ((avg - 1) root),
// root = p_best^(1/n), n decisions among avg choices each. On a grid, n is the number of steps of the best
// path and avg half the mean number of open steps of a cell; tau_min stays below tau_max / 2.
#pragma once

#include <algorithm>
#include <cmath>

#include "algorithms/aco/nest.hpp"
#include "algorithms/aco/trail.hpp"
#include "algorithms/aco/walk.hpp"

namespace pathrace::algorithms {

/// Chance `p_best` to take the best path's choice `steps` times in a row. steps > 0, 0 < p_best < 1.
inline double least_share(double p_best, double steps, double choices) {
  const double root = std::pow(p_best, 1 / steps);
  if (choices <= 1) return 0.5;
  return std::min(0.5, (1 - root) / ((choices - 1) * root));
}

/// Half the mean number of legal steps from a cell that has any.
double mean_choices(const Nest& nest);

/// Mean over the inner cells of a walk of the number of steps whose tau is above the row's least by `lambda`
/// of its range, in units of what a converged trail leaves: the step on, and the step back when deposits
/// go both ways. 1 or less when the trail has converged.
double mean_branching(const Nest& nest, const Trail& trail, const Walk& walk, double lambda, bool both_ways);

}  // namespace pathrace::algorithms
