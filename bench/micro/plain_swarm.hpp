// A plain swarm: a yardstick for algorithms/pso.
//
// The same encoding, cost and velocity rule, written the straightforward way: a particle is an object with
// vectors of points, a segment walks from cell to cell (J. Amanatides, A. Woo, Eurographics 1987) and looks
// each one up, one random number per draw.
#pragma once

#include <vector>

#include "core/planner.hpp"

namespace pathrace::bench::micro {

/// Length of the polyline, and the blocked cells that its segments walk through.
struct PlainVerdict {
  double length = 0;
  int walls = 0;
};

PlainVerdict plain_judge(const OccupancyGrid& grid, const std::vector<Point>& polyline);

/// Way-points between start and goal, box constraints, constriction, a ring of neighbours.
class PlainSwarm {
 public:
  PlainSwarm(const Problem& problem, std::size_t particles, std::size_t waypoints, Stream stream);

  void iterate(Stream stream);
  double best_cost() const;

 private:
  struct Particle {
    std::vector<Point> position;  // start, way-points, goal
    std::vector<Point> velocity;
    std::vector<Point> best;
    double best_cost;
  };
  void judge(Particle& particle) const;
  const Particle& guide_of(std::size_t i) const;

  Problem problem_;
  double penalty_;
  std::vector<Particle> particles_;
};

}  // namespace pathrace::bench::micro
