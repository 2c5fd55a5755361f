// The pheromone trail of a grid, and the choice weights that ants read.
//
// Eight floats per padded cell, one per direction, in rows of 32 bytes. Three arrays of that shape: pheromone
// tau, desirability eta^beta (0 where the step is illegal), and their product, the weight of eq. (1).
// Desirabilities are divided by the largest eta of their row first: probabilities stay the same, and beta =
// 20 on a 512 x 512 map does not underflow.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

#include "core/moves.hpp"

namespace pathrace::algorithms {

class Trail {
 public:
  using Row = std::array<float, direction_count>;
  /// eta of the step in `direction` from the cell with this padded index; positive.
  using Heuristic = std::function<double(std::size_t index, int direction)>;

  Trail(const MoveTable& moves, double initial, double alpha, double beta, const Heuristic& eta);

  /// Weights tau^alpha * eta^beta of the steps from a cell, up to a factor of the row; 0 for illegal steps.
  const float* weights(std::size_t index) const { return weight_[index].data(); }
  float pheromone(std::size_t index, int direction) const {
    return pheromone_[index][static_cast<std::size_t>(direction)];
  }

  /// tau := max(persistence * tau, floor) on every step.
  void evaporate(double persistence, double floor);
  /// tau += amount on the step, and on the step back when `both_ways`.
  void deposit(std::size_t index, int direction, double amount, bool both_ways);
  /// Brings the weights up to date with the pheromone.
  void refresh();

 private:
  const MoveTable& moves_;
  double alpha_;
  std::vector<Row> pheromone_;
  std::vector<Row> desirability_;
  std::vector<Row> weight_;
};

}  // namespace pathrace::algorithms
