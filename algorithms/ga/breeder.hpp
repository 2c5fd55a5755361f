// A breeder: makes individuals, from nothing or from parents, in scratch memory of its own.
//
// Order of the operators: crossover, mutation, insertion with deletion, evaluation (algorithms.md 5.1). An
// individual whose insertion fails is deleted; a fresh random one takes its slot, after `refills` failures in
// a row a copy of the elite, or, while there is none, start and goal with nothing between [I]. Each candidate
// that was built is an evaluation, deleted or not.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "algorithms/ga/population.hpp"
#include "algorithms/ga/random_chromosome.hpp"
#include "algorithms/ga/xie2010.hpp"
#include "core/meter.hpp"
#include "core/stream.hpp"

namespace pathrace::algorithms {

/// What one slot may spend at most, and the clock.
struct SlotLimit {
  std::uint64_t evaluations;
  std::uint64_t checks;
  const Meter& meter;
};

/// Not for use by two threads at once.
class Breeder {
 public:
  /// For chromosomes of at most `capacity` genes.
  Breeder(const Xie2010Settings& settings, const GeneMap& map, std::size_t capacity);
  Breeder(const Breeder&) = delete;  // its parts know each other by address
  Breeder& operator=(const Breeder&) = delete;

  /// A random individual for slot `i`, drawn from stream.fork(i).
  void create(Population& population, std::size_t i, const Stream& stream, const SlotLimit& limit);

  /// Children `i` and `i + 1` (if that is below `count`) of two parents. Selection, cut and child `i` draw
  /// from stream.fork(i), child `i + 1` from stream.fork(i + 1). `elite` is the fittest parent's index.
  void mate(const Population& parents, std::size_t elite, Population& children, std::size_t i,
            std::size_t count, const Stream& stream, const SlotLimit& limit);

 private:
  std::size_t tournament(const Population& parents, Stream& stream) const;
  void join(std::span<const Gene> head, std::span<const Gene> tail);
  void rear(const Population& parents, std::size_t elite, Population& children, std::size_t i, Stream& stream,
            const SlotLimit& limit);
  bool grow(Population& population, std::size_t i, Stream& stream, const SlotLimit& limit);
  void judge_raw(Population& population, std::size_t i) const;

  const Xie2010Settings& settings_;
  const GeneMap& map_;
  PlaceTable places_;
  LoopFreePath path_;
  Crossover crossover_;
  Inserter inserter_;
  RandomChromosome random_;
  std::vector<Gene> genes_;  // of the individual at work, gaps and loops included
};

}  // namespace pathrace::algorithms
