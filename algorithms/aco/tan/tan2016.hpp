// The settings of Tan's colony.
#pragma once

#include "algorithms/aco/colony_settings.hpp"
#include "algorithms/aco/dead_cells.hpp"
#include "algorithms/aco/tan/environment.hpp"

namespace pathrace::algorithms {

struct Tan2016Settings : ColonySettings {
  Tan2016Settings() {
    deposit = 100;
    initial_pheromone = 8;
    dead_end = DeadEnd::backtrack;
  }

  // the pre-planned path
  double amplitude = 1;
  double sigma = 1.5;
  StepValue step_value = StepValue::mean;
  Neighbours neighbours = Neighbours::eight;
  double area_ratio = 2;
  int max_depth = 6;
  // the turns
  double phi = 0.5;
  // the dead ends
  DeadTable dead_table = DeadTable::global_dominated;
  double mu = 0.5;
  double penalty_floor = 1e-6;

  CoverSettings cover() const { return {neighbours, area_ratio, max_depth}; }
  /// For an even pheromone of C.
  GaussianField field(double base) const { return {base, amplitude * base, sigma}; }
};

}  // namespace pathrace::algorithms
