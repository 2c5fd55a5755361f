// The pre-planned path: from obstacle to obstacle along the line from start to goal.
//
//   1. The reference is the segment from the newest start s to the goal.
//   2. A set of circles meets it unless its centres all lie on one side. No set meets it: done.
//   3. Of the nearest set that does, the centre whose direction from s differs least from the goal's becomes
//      the new s.
//   4. Go to 1.
//
// Tan et al., 3.3.1 (3), steps 1 to 4. Taken literally they fail, and are mended so (algorithms.md 2.3):
//   (a) sides and angles come from cross and dot products; slopes are infinite on vertical lines;
//   (b) a set also meets the segment when some centre is closer to it than its radius: one circle on the line
//       has all its centres on one side;
//   (c) only centres whose foot lies strictly between s and the goal count, not those behind either;
//   (d) the nearest set has the nearest counting centre, ties by the order of sets;
//   (e) a set is used once, so that there are at most as many rounds as sets;
//   (f) a centre on the line itself meets it;
//   (g) the result passes through obstacles. It says where to look first, and is no path.
#pragma once

#include <vector>

#include "algorithms/aco/tan/connectivity.hpp"

namespace pathrace::algorithms {

/// The polyline from start to goal, both included. O(circles) per corner of the result.
std::vector<Point> preplanned_path(Point start, Point goal, const std::vector<CircleSet>& sets);

}  // namespace pathrace::algorithms
