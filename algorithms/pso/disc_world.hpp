// The discs that a robot must go around, as its centre sees them: grown by the robot's own radius.
//
// Two discs are adjacent when the robot does not fit between them. Who goes around a disc on the side where
// an adjacent one sits must go around that one, too, and around all that are adjacent to it: the recursive
// Circumference of eq. (10) of Nasrollahy and Javadi. Recursion with a set of visited discs, which rings
// need, reaches all discs that hang together with the first one when the disc in question is taken out. So it
// is unrolled once per step: the neighbours of a disc fall into groups that hang together without it, and
// each group has the sum of its circumferences.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/disc.hpp"

namespace pathrace::algorithms {

/// The workspace is [0, width] x [0, height].
struct Workspace {
  double width = 0;
  double height = 0;

  double diagonal() const;
};

/// Straight-line distance of two points.
double separation(Point a, Point b);

struct DiscNeighbour {
  double angle = 0;       ///< of its centre as seen from this disc, in [-pi, pi]
  std::size_t group = 0;  ///< neighbours of one group hang together without this disc
};

/// A grown disc.
struct Obstacle {
  Point centre;
  double radius = 0;                      ///< of the disc and the robot together
  std::vector<DiscNeighbour> neighbours;  ///< by index
  std::vector<double> circumferences;     ///< per group, of all its discs
  std::vector<double> border_angles;      ///< where the robot does not fit between disc and border
};

/// Adjacent: the gap is at most the robot's diameter plus `tolerance`. In the order of the discs.
/// Time O(m (m + a)) for m discs and a adjacent pairs.
std::vector<Obstacle> grow(std::span<const Disc> discs, double robot_radius, const Workspace& workspace,
                           double tolerance);

}  // namespace pathrace::algorithms
