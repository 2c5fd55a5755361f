#include "algorithms/aco/trail.hpp"

#include <algorithm>

#include "algorithms/aco/power.hpp"

namespace pathrace::algorithms {
namespace {

Trail::Row desirabilities(unsigned mask, std::size_t index, double beta, const Trail::Heuristic& eta) {
  std::array<double, direction_count> value{};
  double largest = 0;
  for (int d = 0; d < direction_count; ++d) {
    if ((mask >> d & 1U) == 0) continue;
    value[static_cast<std::size_t>(d)] = eta(index, d);
    largest = std::max(largest, value[static_cast<std::size_t>(d)]);
  }
  Trail::Row row{};
  for (std::size_t d = 0; d < direction_count; ++d) {
    if ((mask >> d & 1U) != 0) row[d] = static_cast<float>(power(value[d] / largest, beta));
  }
  return row;
}

}  // namespace

Trail::Trail(const MoveTable& moves, double initial, double alpha, double beta, const Heuristic& eta)
    : moves_(moves),
      alpha_(alpha),
      pheromone_(moves.size()),
      desirability_(moves.size()),
      weight_(moves.size()) {
  for (std::size_t index = 0; index < moves.size(); ++index) {
    if (moves[index] == 0) continue;
    pheromone_[index].fill(static_cast<float>(initial));
    desirability_[index] = desirabilities(moves[index], index, beta, eta);
  }
  refresh();
}

void Trail::evaporate(double persistence, double floor) {
  const auto factor = static_cast<float>(persistence);
  const auto least = static_cast<float>(floor);
  for (Row& row : pheromone_) {
    for (float& tau : row) tau = std::max(tau * factor, least);
  }
}

void Trail::deposit(std::size_t index, int direction, double amount, bool both_ways) {
  const auto dtau = static_cast<float>(amount);
  pheromone_[index][static_cast<std::size_t>(direction)] += dtau;
  if (both_ways) {
    pheromone_[moves_.step(index, direction)][static_cast<std::size_t>(opposite(direction))] += dtau;
  }
}

void Trail::refresh() {
  if (alpha_ == 1) {
    for (std::size_t index = 0; index < weight_.size(); ++index) {
      for (std::size_t d = 0; d < direction_count; ++d) {
        weight_[index][d] = pheromone_[index][d] * desirability_[index][d];
      }
    }
    return;
  }
  for (std::size_t index = 0; index < weight_.size(); ++index) {
    if (moves_[index] == 0) continue;
    for (std::size_t d = 0; d < direction_count; ++d) {
      const double tau = power(pheromone_[index][d], alpha_);
      weight_[index][d] = static_cast<float>(tau * desirability_[index][d]);
    }
  }
}

}  // namespace pathrace::algorithms
