// Processors shared out among the threads of a team.
//
// A scheduler may put a thread that is new, or has slept, on the processor of the one that woke it, where it
// waits for that one to pause: five milliseconds have been seen, longer than many a trial, with another
// processor idle. Whose share is another processor never waits there.
#pragma once

#include <sched.h>

namespace pathrace::bench {

/// Of the processors that a thread may run on, every `threads`-th is one share. Where there are fewer
/// processors than threads, or the system does not tell, there are no shares and nobody is moved.
class ProcessorShares {
 public:
  /// Of the calling thread's processors.
  explicit ProcessorShares(int threads);

  /// Whether there are shares.
  bool exist() const { return exist_; }
  /// Whether the calling thread is on share `k` at the moment, if there are shares.
  bool here(int k) const;
  /// The calling thread moves to share `k`, 0..threads-1, and stays there for good.
  void settle(int k) const;
  /// The calling thread moves to share `k`, and may be moved on: threads that it starts may run anywhere.
  void go_to(int k) const;

 private:
  cpu_set_t share(int k) const;

  int threads_;
  bool exist_ = false;
  cpu_set_t processors_;
};

}  // namespace pathrace::bench
