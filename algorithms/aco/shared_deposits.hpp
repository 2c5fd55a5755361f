// Deposits of an iteration, shared out among threads by bands of the map.
//
// The deposits on a step come in ant order, whoever makes them: so each thread goes through all paths, and
// deposits on the rows of a band of its own. Which steps of a path those are is found out first, by the
// thread that is likely to have walked it; others need not even read the rest.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "algorithms/aco/bands.hpp"
#include "algorithms/aco/nest.hpp"
#include "algorithms/aco/trail.hpp"
#include "algorithms/aco/walk.hpp"
#include "core/executor.hpp"

namespace pathrace::algorithms {

class SharedDeposits {
 public:
  /// Nest and trail outlive this; at most `ants` walks. threads >= 1.
  SharedDeposits(const Nest& nest, Trail& trail, std::size_t ants, std::size_t threads);

  /// Adds amounts[k] to each step of the path of walk k, if that has arrived, for k in ascending order.
  void deposit(std::span<const Walk> walks, std::span<const double> amounts, bool both_ways,
               Executor& executor);

 private:
  // Of a path, on a line of its own: neighbours are written by threads of their own.
  struct alignas(64) Stretches {
    std::vector<Stretch> all;
  };

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
