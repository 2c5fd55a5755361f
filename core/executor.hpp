// Executors: who runs the iterations of a loop.
//
// A loop body writes slot i from index i and reads what nobody writes, so the answer does not depend on
// who ran it. An executor is chosen at run time; one call per chunk of indices keeps the virtual call out
// of the loop.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <functional>
#include <memory>
#include <string_view>
#include <type_traits>
#include <utility>

namespace pathrace {

/// A borrowed callable `void(begin, end)`: two words, no allocation.
class ChunkBody {
 public:
  template <typename F>
  requires(!std::is_same_v<std::remove_cvref_t<F>, ChunkBody>)
      ChunkBody(F&& body)  // NOLINT(google-explicit-constructor): a view of any callable
      : object_(static_cast<const void*>(std::addressof(body))),
        call_([](const void* object, std::size_t begin, std::size_t end) {
          (*static_cast<const std::remove_reference_t<F>*>(object))(begin, end);
        }) {}

  void operator()(std::size_t begin, std::size_t end) const { call_(object_, begin, end); }

 private:
  const void* object_;
  void (*call_)(const void*, std::size_t, std::size_t);
};

/// Counts how many different threads took part.
class ThreadCensus {
 public:
  /// Called once per chunk by whoever runs it. Lock-free; counts up to 256 threads.
  void note();
  int count() const { return count_.load(std::memory_order_relaxed); }
  /// Forgets everybody. Not while a loop runs.
  void clear();

 private:
  static constexpr std::size_t max_threads = 256;
  std::array<std::atomic<std::size_t>, max_threads> seen_{};  // thread numbers, 0 = empty
  std::atomic<int> count_{0};
};

class Executor {
 public:
  Executor() = default;
  Executor(const Executor&) = delete;
  Executor& operator=(const Executor&) = delete;
  virtual ~Executor() = default;

  virtual std::string_view name() const = 0;
  /// The most threads that it may use, the caller included.
  virtual int threads() const = 0;
  /// How many different threads have run a chunk since the census began.
  int threads_used() const { return std::max(1, census_.count()); }
  /// Starts counting threads afresh; between trials, never while a loop runs.
  void restart_census() { census_.clear(); }

  /// Calls `body` on chunks of at most `grain` indices that cover 0..count-1 once, and returns when all are
  /// done. May be called from inside a body. When bodies throw, every chunk still runs or is skipped, and
  /// the exception of the lowest chunk comes out.
  void run(std::size_t count, std::size_t grain, ChunkBody body) {
    if (count > 0) run_chunks(count, std::max<std::size_t>(1, grain), body);
  }

  /// Calls `body` once, on the calling thread, and keeps the other threads at hand for the loops that it
  /// runs: who runs many short ones pays for gathering threads once. An exception of the body comes out.
  virtual void with_team(const std::function<void()>& body) { body(); }

 protected:
  virtual void run_chunks(std::size_t count, std::size_t grain, ChunkBody body) = 0;
  ThreadCensus census_;
};

/// Calls `body(i)` for each i in 0..count-1, in chunks of `grain`.
template <typename Body>
void for_each_index(Executor& executor, std::size_t count, std::size_t grain, const Body& body) {
  const auto chunk = [&body](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) body(i);
  };
  executor.run(count, grain, chunk);
}

}  // namespace pathrace
