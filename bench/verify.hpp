// Verification: does a store hold what its trials give?
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "bench/runner.hpp"
#include "results/store.hpp"

namespace pathrace::bench {

struct Verification {
  std::uint64_t rows = 0;     ///< in the store
  std::uint64_t rerun = 0;    ///< run again
  std::uint64_t skipped = 0;  ///< cut short by a wall-time limit, or of planners that promise no repetition
  std::vector<std::string> differences;  ///< one line each; names the row
};

/// Checks every row against its key, its own digest and the referee's figures; runs all of them again, or
/// `sample` spread evenly, and compares everything but costs.
Verification verify(const results::Store& store, const TrialPlan& plan, std::optional<std::size_t> sample,
                    const RunOptions& options);

}  // namespace pathrace::bench
