// An executor for tests that a planner's loops are work for several threads, however busy the machine is.
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <set>
#include <string_view>
#include <thread>

#include "core/executor.hpp"

namespace pathrace::testing {

/// Hands loops on to another executor. Until two of its threads have come, a chunk of a loop with several
/// waits for the second one; after ten seconds in vain, four times, it waits no longer.
class MeetingExecutor final : public Executor {
 public:
  explicit MeetingExecutor(Executor& inner) : inner_(inner) {}

  std::string_view name() const override { return inner_.name(); }
  int threads() const override { return inner_.threads(); }
  void with_team(const std::function<void()>& body) override { inner_.with_team(body); }

  /// Whether two threads have come to loops with several chunks.
  bool has_met() const { return present_.size() > 1; }

 private:
  void run_chunks(std::size_t count, std::size_t grain, ChunkBody body) override {
    inner_.run(count, grain, [&](std::size_t begin, std::size_t end) {
      if (count > grain) meet();
      body(begin, end);
    });
  }

  void meet() {
    std::unique_lock lock(mutex_);
    present_.insert(std::this_thread::get_id());
    somebody_came_.notify_all();
    if (patience_ == 0) return;
    const bool met = somebody_came_.wait_for(lock, std::chrono::seconds(10), [this] { return has_met(); });
    if (!met) --patience_;
  }

  Executor& inner_;
  std::mutex mutex_;
  std::condition_variable somebody_came_;
  std::set<std::thread::id> present_;
  int patience_ = 4;
};

}  // namespace pathrace::testing
