// Evolution: generations of individuals under a budget.
//
// Generation 0 is random; each later one has as many children as the population has places, bred from
// parents by tournament, and the fittest parent that is a path (the elite) takes the place of the least fit
// child, if that is less fit [I]. Fitness steers the search; the answer is the shortest path that any
// individual was, which on the paper's maps is the fittest individual of the last generation.
//
// Individual i of generation g draws from stream.fork(g).fork(i). One candidate chromosome = one evaluation,
// one cell looked at by insertion = one check, one generation after the first = one iteration. Counters of
// the record: `deleted`, candidates whose insertion failed; `detours`, local searches.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <vector>

#include "algorithms/ga/breeder.hpp"
#include "algorithms/ga/gene_map.hpp"
#include "algorithms/ga/population.hpp"
#include "core/planner.hpp"

namespace pathrace::algorithms {

class Evolution {
 public:
  /// Longest chromosome of a population of this size, in cells; an individual that needs more is deleted.
  static std::size_t longest_chromosome(std::size_t population);

  /// All three outlive the evolution. Start and goal are different cells.
  Evolution(const Xie2010Settings& settings, const Problem& problem, Context& context);

  /// Evolves until the budget is spent.
  Answer run();

 private:
  void found();
  void breed(std::uint64_t generation);
  std::size_t chunk_size(std::size_t tasks);
  std::size_t charge(const Population& population, std::size_t count);
  void keep_best(const Population& population, std::size_t count);
  Answer answer() const;
  void draw(Overlay& overlay) const;

  const Xie2010Settings& settings_;
  const Problem& problem_;
  Context& context_;
  GeneMap map_;
  std::size_t capacity_;
  Population parents_;
  Population children_;
  std::deque<Breeder> breeders_;  // one per chunk of individuals
  std::uint64_t work_ = 0;        // cells handled for the last generation
  LatticeLength shortest_;
  std::vector<Gene> best_;
};

}  // namespace pathrace::algorithms
