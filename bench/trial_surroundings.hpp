// What surrounds a trial: a floating-point environment that no other trial has touched, and the clocks that
// say what processors gave it.
#pragma once

#include "bench/float_environment.hpp"
#include "bench/processor_time.hpp"
#include "core/executor.hpp"
#include "core/record.hpp"

namespace pathrace::bench {

/// Around a planner's call, on its thread. At the end of the scope `costs` has the processor time: of the
/// calling thread where the executor has no other, else of the whole process, which is the trial's only where
/// no other runs beside it. `crowded` is set when the calling thread, whose planner never waits, was kept
/// from working; `wall_s` is there by then.
class TrialSurroundings {
 public:
  TrialSurroundings(const Executor& executor, Costs& costs)
      : costs_(costs), alone_(executor.threads() == 1), thread_(thread_time()), process_(process_time()) {}
  TrialSurroundings(const TrialSurroundings&) = delete;
  TrialSurroundings& operator=(const TrialSurroundings&) = delete;
  ~TrialSurroundings() {
    const ProcessorTime own = thread_time() - thread_;
    const ProcessorTime used = alone_ ? own : process_time() - process_;
    costs_.user_s = used.user_s;
    costs_.system_s = used.system_s;
    costs_.crowded = costs_.crowded || disturbed(costs_.wall_s, own);
  }

 private:
  DefaultFloats floats_;
  Costs& costs_;
  bool alone_;
  ProcessorTime thread_;
  ProcessorTime process_;
};

}  // namespace pathrace::bench
