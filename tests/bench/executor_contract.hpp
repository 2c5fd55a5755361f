// What the tests of executors share: every executor, with several numbers of threads.
//
// A rendezvous is a loop with as many chunks as threads, in which every chunk waits until all have begun:
// it only ends when that many threads run at the same time, however few the cores are.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <atomic>
#include <barrier>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "bench/executors.hpp"
#include "tests/support/sanitizers.hpp"

namespace pathrace::bench {

inline std::vector<std::string> names_under_test() {
  return pathrace::testing::thread_sanitizer ? std::vector<std::string>{"serial", "threads"}
                                             : executor_names();
}

using Indices = std::vector<int>;

// How often each index was visited by one loop.
inline Indices visits(Executor& executor, std::size_t count, std::size_t grain) {
  std::vector<std::atomic<int>> visited(count);
  for_each_index(executor, count, grain, [&](std::size_t i) { ++visited[i]; });
  return {visited.begin(), visited.end()};
}

// Ends only when `executor.threads()` threads are in it together.
inline void rendezvous(Executor& executor) {
  std::barrier together(executor.threads());
  for_each_index(executor, static_cast<std::size_t>(executor.threads()), 1,
                 [&](std::size_t) { together.arrive_and_wait(); });
}

class EveryExecutor : public ::testing::TestWithParam<std::tuple<std::string, int>> {
 protected:
  std::unique_ptr<Executor> another() const {
    return make_executor(std::get<0>(GetParam()), std::get<1>(GetParam()));
  }
  Executor& executor() { return *executor_; }
  bool parallel() const { return executor_->threads() > 1; }

 private:
  std::unique_ptr<Executor> executor_ = another();
};

inline auto executors_and_threads() {
  return ::testing::Combine(::testing::ValuesIn(names_under_test()), ::testing::Values(1, 2, 4));
}

inline std::string test_name(const ::testing::TestParamInfo<EveryExecutor::ParamType>& info) {
  return fmt::format("{}_{}", std::get<0>(info.param), std::get<1>(info.param));
}

}  // namespace pathrace::bench
