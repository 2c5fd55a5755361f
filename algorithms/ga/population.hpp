// A population: chromosomes of variable length in slots of fixed capacity, one flat array.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "algorithms/ga/gene_map.hpp"
#include "core/lattice_length.hpp"

namespace pathrace::algorithms {

/// What is known about a chromosome. A cache line of its own, since neighbours may be written by other
/// threads.
struct alignas(64) Individual {
  std::uint32_t size = 0;  ///< genes
  bool feasible = false;   ///< a path without gaps
  bool cut = false;        ///< the budget ended before it was finished
  double fitness = std::numeric_limits<double>::infinity();
  LatticeLength length;           ///< of a feasible one
  std::uint64_t evaluations = 1;  ///< candidates that were built for this slot
  std::uint64_t checks = 0;
  std::uint32_t deleted = 0;  ///< of them, those whose insertion failed
  std::uint32_t detours = 0;
};

/// Feasible before infeasible, then by fitness.
inline bool fitter(const Individual& a, const Individual& b) {
  return a.feasible != b.feasible ? a.feasible : a.fitness < b.fitness;
}

class Population {
 public:
  /// Chromosomes of at most `capacity` genes. Memory that no chromosome reaches is never touched.
  Population(std::size_t count, std::size_t capacity)
      : capacity_(capacity), individuals_(count), genes_(new Gene[count * capacity]) {}

  std::size_t size() const { return individuals_.size(); }
  Individual& operator[](std::size_t i) { return individuals_[i]; }
  const Individual& operator[](std::size_t i) const { return individuals_[i]; }

  std::span<const Gene> genes(std::size_t i) const {
    return {genes_.get() + i * capacity_, individuals_[i].size};
  }
  /// Room for a chromosome; its individual's size says how much of it is in use.
  std::span<Gene> slot(std::size_t i) { return {genes_.get() + i * capacity_, capacity_}; }

  /// Individual `i` becomes a copy of `other`, which may not be larger than the capacity.
  void copy(std::size_t i, const Individual& other, std::span<const Gene> genes);

  /// Indices of the fittest and the least fit of the first `count` > 0; the first of equals.
  std::size_t best(std::size_t count) const;
  std::size_t worst(std::size_t count) const;

 private:
  std::size_t capacity_;
  std::vector<Individual> individuals_;
  std::unique_ptr<Gene[]> genes_;  // NOLINT: left uninitialised on purpose
};

}  // namespace pathrace::algorithms
