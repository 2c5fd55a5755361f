// Processors shared out among the threads of a team.
//
// A scheduler may put a thread that is new, or has slept, on the processor of the one that woke it, where it
// waits for that one to pause: five milliseconds have been seen, longer than many a trial, with another
// processor idle. Whose share is another processor never waits there.
#pragma once

#include <sched.h>

#include <cstddef>
#include <vector>

namespace pathrace::bench {

/// Of the processors that a thread may run on, every `threads`-th is one share. Where there are fewer
/// processors than threads, or the system does not tell, there are no shares and nobody is moved.
class ProcessorShares {
 public:
  /// Of the calling thread's processors.
  explicit ProcessorShares(int threads);

  /// Whether there are shares.
  bool exist() const { return !shares_.empty(); }
  /// Whether the calling thread is on share `k` at the moment. False when there are none.
  bool here(int k) const;
  /// The calling thread moves to share `k`, 0..threads-1, and stays there for good.
  void settle(int k) const;
  /// The calling thread moves to share `k`, and may be moved on: threads that it starts may run anywhere.
  void go_to(int k) const;

 private:
  const cpu_set_t& share(int k) const { return shares_[static_cast<std::size_t>(k)]; }

  std::vector<cpu_set_t> shares_;
};

}  // namespace pathrace::bench
