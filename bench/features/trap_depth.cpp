// Trap depth: how far a greedy walk has to go back.
//
// The walk starts at the start and always steps to the unvisited neighbour nearest to the goal, by squared
// Euclidean distance; the first direction (E, SE, S, ...) wins a tie. When it is stuck it steps back along
// its way. It visits each cell once, so it comes to the goal, or back to the start for good: then there is no
// way.
#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <vector>

#include "bench/features/feature.hpp"
#include "core/checkpoint.hpp"

namespace pathrace::bench {
namespace {

class GreedyWalk {
 public:
  explicit GreedyWalk(FeatureContext& context)
      : grid_(context.scenario().grid()),
        moves_(context.moves()),
        start_(context.scenario().start),
        goal_(context.scenario().goal),
        visited_(moves_.size(), 0) {}

  /// The longest run of steps back in a row; nothing when there is no way.
  std::optional<double> longest_retreat() {
    const std::size_t goal = grid_.index(goal_);
    enter(grid_.index(start_));
    std::size_t longest = 0;
    std::size_t retreat = 0;
    Pace pace;
    while (way_.back() != goal) {
      pace.step();
      const int direction = nearest_to_goal(way_.back());
      if (direction >= 0) {
        retreat = 0;
        enter(moves_.step(way_.back(), direction));
        continue;
      }
      if (way_.size() == 1) return std::nullopt;
      way_.pop_back();
      longest = std::max(longest, ++retreat);
    }
    return static_cast<double>(longest);
  }

 private:
  void enter(std::size_t cell) {
    visited_[cell] = 1;
    way_.push_back(cell);
  }

  std::int64_t squared_distance(std::size_t index) const {
    const Cell cell = grid_.cell(index);
    const std::int64_t dx = cell.x - goal_.x;
    const std::int64_t dy = cell.y - goal_.y;
    return dx * dx + dy * dy;
  }

  int nearest_to_goal(std::size_t index) const {
    int nearest = -1;
    std::int64_t least = std::numeric_limits<std::int64_t>::max();
    for (unsigned mask = moves_[index]; mask != 0; mask &= mask - 1) {
      const int direction = std::countr_zero(mask);
      const std::size_t next = moves_.step(index, direction);
      if (visited_[next] != 0) continue;
      const std::int64_t distance = squared_distance(next);
      if (distance >= least) continue;
      least = distance;
      nearest = direction;
    }
    return nearest;
  }

  const OccupancyGrid& grid_;
  const MoveTable& moves_;
  Cell start_;
  Cell goal_;
  std::vector<std::uint8_t> visited_;
  std::vector<std::size_t> way_;
};

std::optional<double> trap_depth(FeatureContext& context) {
  return GreedyWalk(context).longest_retreat();
}

}  // namespace

Feature trap_depth_feature() {
  return {"trap_depth", "cells", "most steps back in a row of a greedy walk from start to goal",
          FeatureType::integer, trap_depth};
}

}  // namespace pathrace::bench
