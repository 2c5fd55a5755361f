// Processor time: what the kernel says that threads have used (getrusage(2), in microseconds).
#pragma once

namespace pathrace::bench {

struct ProcessorTime {
  double user_s = 0;
  double system_s = 0;

  double total_s() const { return user_s + system_s; }
  ProcessorTime operator-(const ProcessorTime& earlier) const {
    return {user_s - earlier.user_s, system_s - earlier.system_s};
  }
};

/// Of the calling thread since it began.
ProcessorTime thread_time();
/// Of all threads of the process since it began, those that have ended included.
ProcessorTime process_time();

/// Whether a thread that never waits was kept from working: `used` falls short of the wall time by more than
/// a fifth, and by more than 10 ms, below which the scheduler's own steps would be seen.
bool disturbed(double wall_s, const ProcessorTime& used);

}  // namespace pathrace::bench
