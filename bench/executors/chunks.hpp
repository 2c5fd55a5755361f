// One call of Executor::run, cut into chunks that any thread may run in any order.
//
// Chunk k is [k * grain, min((k + 1) * grain, count)). When bodies throw, the exception of the lowest
// chunk comes out, whoever ran it and whenever: a failure skips only the chunks above it. Each chunk computes
// in the default floating-point environment.
#pragma once

#include <atomic>
#include <cstddef>
#include <exception>
#include <limits>
#include <mutex>

#include "core/executor.hpp"

namespace pathrace::bench {

// What every chunk reads shares a cache line: threads that join a loop fetch it from another core.
class alignas(64) Chunks {
 public:
  Chunks(std::size_t count, std::size_t grain, ChunkBody body, ThreadCensus& census)
      : count_(count), grain_(grain), body_(body), census_(census) {}

  std::size_t size() const { return count_ / grain_ + (count_ % grain_ != 0 ? 1 : 0); }

  /// All chunks in order on the calling thread; an exception comes straight out.
  void run_inline();

  /// Runs chunk k, or skips it when a lower one has thrown. Keeps an exception for `rethrow`, because one
  /// that leaves a pool's thread or an OpenMP region ends the process.
  void run(std::size_t k) noexcept;

  /// Throws what the lowest chunk threw, if any did. Called once every chunk is done.
  void rethrow() const;

 private:
  void run_body(std::size_t k);

  std::size_t count_;
  std::size_t grain_;
  ChunkBody body_;
  ThreadCensus& census_;
  std::atomic<std::size_t> failed_{std::numeric_limits<std::size_t>::max()};  // the lowest chunk that threw
  std::mutex mutex_;
  std::exception_ptr failure_;
};

}  // namespace pathrace::bench
