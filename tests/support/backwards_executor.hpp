// An executor for tests that nothing depends on the order in which chunks are run.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string_view>

#include "core/executor.hpp"

namespace pathrace::testing {

/// Says that it has two threads, and runs the chunks of a loop last to first. Counts loops.
class BackwardsExecutor final : public Executor {
 public:
  std::string_view name() const override { return "backwards"; }
  int threads() const override { return 2; }
  int loops = 0;

 private:
  void run_chunks(std::size_t count, std::size_t grain, ChunkBody body) override {
    ++loops;
    for (std::size_t k = (count + grain - 1) / grain; k-- > 0;)
      body(k * grain, std::min(count, (k + 1) * grain));
  }
};

}  // namespace pathrace::testing
