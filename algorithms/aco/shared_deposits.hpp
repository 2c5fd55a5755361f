// Deposits of an iteration, shared out among threads by bands of the map.
//
// The deposits on a step come in ant order, whoever makes them: so each thread goes through all paths, and
// deposits on the rows of a band of its own. Which steps of a path those are is found out first, by the
// thread that is likely to have walked it; others need not even read the rest. Threads that have nobody left
// to walk, and wait for those who have, may do so for the ants that are back.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "algorithms/aco/bands.hpp"
#include "algorithms/aco/nest.hpp"
#include "algorithms/aco/roll_call.hpp"
#include "algorithms/aco/trail.hpp"
#include "algorithms/aco/walk.hpp"
#include "core/executor.hpp"

namespace pathrace::algorithms {

class SharedDeposits {
 public:
  /// Nest and trail outlive this; at most `ants` walks. threads >= 1.
  SharedDeposits(const Nest& nest, Trail& trail, std::size_t ants, std::size_t threads);

  /// Splits the paths of the walks that are back in this round, and will not change before the deposits on
  /// them. For several threads at a time, 0..threads-1, while others walk; each begins with the paths that it
  /// is likely to have walked.
  void prepare(std::span<const Walk> walks, const RollCall& roll_call, std::uint32_t round,
               std::size_t thread);
  /// Adds amounts[k] to each step of the path of walk k, if that has arrived, for k in ascending order.
  /// Paths that were prepared in this round are not split again.
  void deposit(std::span<const Walk> walks, std::span<const double> amounts, bool both_ways,
               std::uint32_t round, Executor& executor);

 private:
  // Of a path, on a line of its own: neighbours are written by threads of their own.
  struct alignas(64) Stretches {
    std::vector<Stretch> all;
    std::atomic<std::uint32_t> round{0};  // in which the path was prepared last
  };

  void split(std::size_t ant, const Walk& walk);
  void split_the_rest(std::span<const Walk> walks, std::uint32_t round, Executor& executor);
  void deposit_within(CellRange cells, std::span<const Walk> walks, std::span<const double> amounts,
                      bool both_ways);
  void deposit_on(std::span<const Stretch> stretches, std::span<const std::uint8_t> path, double amount,
                  bool both_ways);

  const Nest& nest_;
  Trail& trail_;
  std::size_t threads_;
  Bands bands_;
  std::vector<Stretches> stretches_;  // a slot per ant
};

}  // namespace pathrace::algorithms
