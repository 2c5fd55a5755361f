// The meter: spends a trial's budget, counts its work and records each improvement.
//
// A planner asks the meter what it may still do and tells it what it did; the harness reads the counters.
// Only `out_of_time` may be called from inside a parallel loop; everything else belongs to the thread
// that runs the planner, but for `work`, `best_cost` and `elapsed_s`, which others may read to show progress.
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "core/budget.hpp"

namespace pathrace {

struct Work {
  std::uint64_t evaluations = 0;
  std::uint64_t iterations = 0;
  std::uint64_t checks = 0;

  friend bool operator==(const Work&, const Work&) = default;
};

/// One improvement of the best cost so far, with the work and the time spent until then.
struct TracePoint {
  Work work;
  double wall_s = 0;
  double cost = 0;
};

/// Something a planner counted beside its work, such as ants that arrived.
struct Counter {
  std::string name;  ///< lower-case letters, digits and underscores
  std::uint64_t value = 0;

  friend bool operator==(const Counter&, const Counter&) = default;
};

class Meter {
 public:
  static constexpr std::uint64_t unlimited = std::numeric_limits<std::uint64_t>::max();

  explicit Meter(const Budget& budget);

  /// True when a limit is reached. The main loop of every planner asks this.
  bool exhausted() const;
  /// True once the wall-time limit has passed; the trial is then marked `timed`. True as well once the
  /// process is asked to stop; the trial is then `interrupted`. Safe in parallel loops.
  bool out_of_time() const;

  std::uint64_t evaluations_left() const { return left(budget_.evaluations, evaluations_.value()); }
  std::uint64_t checks_left() const { return left(budget_.checks, checks_.value()); }
  /// How many of `wanted` evaluations the budget still admits: the last batch is cut, never exceeded.
  std::size_t admitted(std::size_t wanted) const;

  void spend_evaluations(std::uint64_t count) { evaluations_.add(count); }
  void spend_checks(std::uint64_t count) { checks_.add(count); }
  void end_iteration() { iterations_.add(1); }

  /// Records the cost when it is finite and below every cost before; the trace strictly falls.
  void improved(double cost);

  /// Adds to the counter of this name, which starts at 0 when it is first named. Part of the record, not of
  /// the budget nor of the digest.
  void count(std::string_view name, std::uint64_t amount);

  /// The planner has tried everything: an empty answer then claims that there is no way, whatever is spent.
  void conclude() { concluded_ = true; }
  bool concluded() const { return concluded_; }

  const Budget& budget() const { return budget_; }
  Work work() const { return {evaluations_.value(), iterations_.value(), checks_.value()}; }
  /// The last cost of the trace; infinite while there is none.
  double best_cost() const { return best_cost_.load(std::memory_order_relaxed); }
  const std::vector<TracePoint>& trace() const { return trace_; }
  /// In the order in which they were first named.
  const std::vector<Counter>& counters() const { return counters_; }
  bool timed() const { return timed_.load(std::memory_order_relaxed); }
  /// True when somebody was told to end because the process is asked to stop: the trial is worth nothing.
  bool interrupted() const { return interrupted_.load(std::memory_order_relaxed); }
  /// True when a limit on work or time has been reached, without reading the clock.
  bool spent() const;
  /// True when some counter is above its limit: the planner broke the rules.
  bool exceeded() const;
  double elapsed_s() const;

 private:
  // Written by one thread, read by any.
  class Count {
   public:
    std::uint64_t value() const { return value_.load(std::memory_order_relaxed); }
    void add(std::uint64_t amount) { value_.store(value() + amount, std::memory_order_relaxed); }

   private:
    std::atomic<std::uint64_t> value_{0};
  };

  static std::uint64_t left(const std::optional<std::uint64_t>& limit, std::uint64_t spent) {
    if (!limit) return unlimited;
    return spent < *limit ? *limit - spent : 0;
  }

  Budget budget_;
  Count evaluations_;
  Count iterations_;
  Count checks_;
  std::atomic<double> best_cost_{std::numeric_limits<double>::infinity()};
  std::vector<TracePoint> trace_;
  std::vector<Counter> counters_;
  bool concluded_ = false;
  std::chrono::steady_clock::time_point begin_;
  mutable std::atomic<bool> timed_{false};
  mutable std::atomic<bool> interrupted_{false};
};

}  // namespace pathrace
