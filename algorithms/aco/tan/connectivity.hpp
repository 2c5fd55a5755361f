// Which circles belong together.
//
// Equation (4): two circles are connected when their radii sum to more than the distance of their centres.
// The paper leaves equality open; circles that touch are connected here, within 1e-9. A set is a connected
// component of that relation, circles that meet no other included (algorithms.md 2.2).
#pragma once

#include <vector>

#include "algorithms/aco/tan/enclosing_circle.hpp"

namespace pathrace::algorithms {

/// Circles that reach each other through touching circles.
using CircleSet = std::vector<Circle>;

/// A_ij of equation (4).
bool connected(const Circle& a, const Circle& b);

/// The sets, ordered by their first circle; circles keep their order. Sorts by left edge and compares a
/// circle only with those that begin before it ends: O(n log n + pairs whose columns overlap), no n x n
/// matrix.
std::vector<CircleSet> connected_sets(const std::vector<Circle>& circles);

}  // namespace pathrace::algorithms
