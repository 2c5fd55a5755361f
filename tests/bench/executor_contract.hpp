// What the tests of executors share: every executor, with several numbers of threads.
//
// A rendezvous is a loop with as many chunks as threads, in which every chunk waits until all have begun:
// it only succeeds when that many threads run at the same time, however few the cores are.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <tuple>
#include <vector>

#include "bench/executors.hpp"
#include "tests/support/trials.hpp"

namespace pathrace::bench {

using Indices = std::vector<int>;

// How often each index was visited by one loop.
inline Indices visits(Executor& executor, std::size_t count, std::size_t grain) {
  std::vector<std::atomic<int>> visited(count);
  for_each_index(executor, count, grain, [&](std::size_t i) { ++visited[i]; });
  return {visited.begin(), visited.end()};
}

// True when as many threads as the executor has were in chunks of one loop at the same time.
inline bool all_meet(Executor& executor) {
  using namespace std::chrono_literals;
  const auto expected = static_cast<std::size_t>(executor.threads());
  std::mutex mutex;
  std::condition_variable somebody_came;
  std::size_t present = 0;
  bool in_vain = false;
  for_each_index(executor, expected, 1, [&](std::size_t) {
    std::unique_lock lock(mutex);
    ++present;
    somebody_came.notify_all();
    const auto over = [&] { return in_vain || present == expected; };
    if (!somebody_came.wait_for(lock, 10s, over)) in_vain = true;
  });
  return !in_vain;
}

// TBB promises no thread to anybody, and very rarely one does not come: then once more.
inline void rendezvous(Executor& executor) {
  constexpr int attempts = 4;
  for (int attempt = 0; attempt < attempts; ++attempt) {
    if (all_meet(executor)) return;
    executor.restart_census();
  }
  ADD_FAILURE() << executor.name() << ": " << executor.threads() << " threads never came together";
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
  return ::testing::Combine(::testing::ValuesIn(pathrace::testing::executors_under_test()),
                            ::testing::Values(1, 2, 4));
}

inline std::string test_name(const ::testing::TestParamInfo<EveryExecutor::ParamType>& info) {
  return fmt::format("{}_{}", std::get<0>(info.param), std::get<1>(info.param));
}

}  // namespace pathrace::bench
