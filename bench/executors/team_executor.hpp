// Executors whose threads stay at hand: the loops inside of with_team go to a team.
#pragma once

#include <atomic>
#include <functional>

#include "bench/executors/chunks.hpp"
#include "bench/executors/processor_shares.hpp"
#include "bench/executors/team.hpp"

namespace pathrace::bench {

/// What such executors have in common. They differ in where the threads come from, and in what they do with a
/// loop outside of a team.
class TeamExecutor : public Executor {
 public:
  explicit TeamExecutor(int threads) : threads_(threads), shares_(threads) {}

  int threads() const final { return threads_; }
  /// In a loop of a team, and in a team, there is no second one: the body is merely called.
  void with_team(const std::function<void()>& body) final;

 protected:
  using Lead = std::function<void(Team&)>;

  /// Makes a team and lets the calling thread lead it. What `lead` throws comes out.
  virtual void gather(const Lead& lead) = 0;
  /// Asks threads to `serve` the team, unless they do already: called before its first loop.
  virtual void call_helpers(Team& /*team*/) {}
  /// A loop outside of a team, of two chunks or more, for two threads or more.
  virtual void run_apart(Chunks& chunks) = 0;

  /// Gathers the threads of an outermost team once, and lets each of them find its share: the first trial is
  /// not to wait for that. For constructors.
  void start();
  /// Of an outermost team: the leader's is 0, and its helpers' are the others.
  const ProcessorShares& shares() const { return shares_; }
  /// A helper's, once it is where it belongs.
  void arrive() { ++arrived_; }

  /// Whether the calling thread runs nothing for an executor of this kind.
  static bool outermost();
  /// Runs a chunk of a loop outside of teams, as one in which there may be other loops.
  static void run_apart(Chunks& chunks, std::size_t k);
  /// Calls lead(team), and dismisses the team at the end, also when `lead` throws.
  void lead_team(Team& team, const Lead& lead) const;
  /// The leader's loop.
  void run_in(Team& team, Chunks& chunks) const;
  /// A helper's life in a team of this executor.
  void serve(Team& team) const;

 private:
  void run_chunks(std::size_t count, std::size_t grain, ChunkBody body) final;

  int threads_;
  ProcessorShares shares_;
  std::atomic<int> arrived_{0};  // over all teams
};

}  // namespace pathrace::bench
