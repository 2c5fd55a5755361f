// Checkpoints: where long work may be cut short before it has anything to show.
//
// Set-up on a map, proofs of optima and features of scenarios call `checkpoint` in their long loops, some
// hundred times a second or more. Whoever has an answer to return asks the meter instead.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pathrace {

class Meter;

/// True once the process is asked to stop, as by Ctrl-C: meters are then out of time, and what they cut short
/// is not recorded. Set by signal handlers.
inline std::atomic<bool> stop_requested{false};

/// The process is asked to stop. No fault: it passes through everything that turns exceptions into verdicts.
class Interrupted {};

/// The trial is out of time before its planner had anything to show; its verdict is `budget`.
class OutOfTime {};

/// Throws Interrupted when the process is asked to stop, OutOfTime when the meter of the trial that runs on
/// this thread says so.
void checkpoint();

/// While it lives, checkpoints of this thread ask the meter. The innermost counts.
class TrialScope {
 public:
  explicit TrialScope(const Meter& meter);
  TrialScope(const TrialScope&) = delete;
  TrialScope& operator=(const TrialScope&) = delete;
  ~TrialScope();

 private:
  const Meter* outer_;
};

/// A checkpoint each 4,096 calls, for loops over cells.
class Pace {
 public:
  void step() {
    if (++steps_ % 4096 == 0) checkpoint();
  }

 private:
  std::uint32_t steps_ = 0;
};

/// `values.assign(count, value)` with checkpoints: the first touch of large memory takes its time.
template <typename T, typename Allocator>
void assign_gradually(std::vector<T, Allocator>& values, std::size_t count, const T& value) {
  constexpr std::size_t portion = std::max<std::size_t>(1, (std::size_t{1} << 22) / sizeof(T));
  values.clear();
  values.reserve(count);
  while (values.size() < count) {
    checkpoint();
    values.insert(values.end(), std::min(portion, count - values.size()), value);
  }
}

/// A vector made so.
template <typename Vector>
Vector filled_gradually(std::size_t count, const typename Vector::value_type& value) {
  Vector values;
  assign_gradually(values, count, value);
  return values;
}

}  // namespace pathrace
