// Plain ants: a yardstick for the walkers of algorithms/aco.
//
// The same rules (tabu list, eq. (1), back-tracking), written the straightforward way: one ant after another,
// neighbours in a loop, weights in doubles and products of tables, a roulette that walks the cumulative sum,
// a fresh list of visited cells per ant.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/planner.hpp"

namespace pathrace::bench::micro {

struct PlainWalk {
  bool arrived = false;
  std::vector<std::size_t> path;
  std::uint64_t decisions = 0;
};

class PlainColony {
 public:
  /// eta = 1 / distance to the goal, 100 at the goal.
  PlainColony(const Problem& problem, double beta, bool backtrack);

  PlainWalk walk(Stream stream) const;
  /// tau := persistence * tau + 1 / length on the steps of each walk that arrived, both ways.
  void learn(const std::vector<PlainWalk>& walks, double persistence);

 private:
  struct Neighbour {
    std::size_t cell;
    std::size_t reverse;  // place of the step back in the neighbour's own list
    double length;
    double desirability;
    double pheromone;
  };
  int choose(std::size_t cell, const std::vector<bool>& visited, Stream& stream) const;

  std::vector<std::vector<Neighbour>> neighbours_;
  std::size_t start_;
  std::size_t goal_;
  bool backtrack_;
};

}  // namespace pathrace::bench::micro
