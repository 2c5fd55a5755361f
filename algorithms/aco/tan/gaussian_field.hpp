// Initial pheromone: a constant, and a Gaussian ridge along the pre-planned path.
//
//   tau0(cell) = C + A exp(-d^2 / (2 sigma^2)),  d = distance from the cell's centre to the polyline
//
// "A certain amount of Gaussian-distributed pheromone, from the path to both sides"; the formula is ours
// (Tan et al., 3.3.1 (4); algorithms.md 2.4). Cut at three sigma. Only free cells are raised: the polyline
// passes through obstacles.
#pragma once

#include <array>
#include <string_view>
#include <utility>
#include <vector>

#include "core/grid.hpp"
#include "core/names.hpp"

namespace pathrace::algorithms {

struct GaussianField {
  double base = 8;       ///< C
  double amplitude = 8;  ///< A; 0 leaves exactly C everywhere
  double sigma = 1.5;    ///< cells; positive
};

/// How a step's pheromone follows from the cells at its ends.
enum class StepValue { target, mean };

/// tau0 by padded index; C in blocked cells. Expects a polyline of at least one point.
std::vector<double> gaussian_field(const OccupancyGrid& grid, const std::vector<Point>& polyline,
                                   const GaussianField& field);

constexpr double step_value(StepValue rule, double from, double to) {
  return rule == StepValue::target ? to : (from + to) / 2;
}

}  // namespace pathrace::algorithms

namespace pathrace {
template <>
inline constexpr auto names_of<algorithms::StepValue> =
    std::to_array<std::pair<algorithms::StepValue, std::string_view>>({
        {algorithms::StepValue::target, "target"},
        {algorithms::StepValue::mean, "mean"},
    });
}  // namespace pathrace
