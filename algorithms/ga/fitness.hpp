// Fitness of a chromosome, to be minimised: f = (1 + 1 / sqrt(n + 1)) D.
//
// n is the number of cells in the chromosome, start and goal included, D the sum of straight distances
// between consecutive cells. For a path without gaps D comes from exact counts of steps, in a loop that
// vector units like; for one with gaps it is a sum in the order of the genes.
//
// Xie, Yu, 2010, section 2.3. In lengths of an edge of a cell; the paper's are 50 cm.
#pragma once

#include <cmath>
#include <cstddef>
#include <span>

#include "algorithms/ga/gene_map.hpp"
#include "core/lattice_length.hpp"

namespace pathrace::algorithms {

inline double fitness(std::size_t cells, double distance) {
  return (1 + 1 / std::sqrt(static_cast<double>(cells + 1))) * distance;
}

/// Length of a path whose consecutive cells are neighbours.
inline LatticeLength step_counts(std::span<const Gene> path, std::size_t stride) {
  const auto row = static_cast<std::uint32_t>(stride);
  std::uint32_t straight = 0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const std::uint32_t forward = path[i] - path[i - 1];
    const std::uint32_t backward = path[i - 1] - path[i];
    straight +=
        static_cast<std::uint32_t>((forward == 1) | (backward == 1) | (forward == row) | (backward == row));
  }
  const auto steps = static_cast<std::int64_t>(path.empty() ? 0 : path.size() - 1);
  return {straight, steps - straight};
}

/// Sum of straight distances between consecutive cells, wherever they lie.
inline double straight_distances(const GeneMap& map, std::span<const Gene> genes) {
  double sum = 0;
  for (std::size_t i = 1; i < genes.size(); ++i) {
    const Cell a = map.cell(genes[i - 1]);
    const Cell b = map.cell(genes[i]);
    const double dx = b.x - a.x;
    const double dy = b.y - a.y;
    sum += std::sqrt(dx * dx + dy * dy);
  }
  return sum;
}

}  // namespace pathrace::algorithms
