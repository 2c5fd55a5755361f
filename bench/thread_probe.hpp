// Whether the system grants threads, asked before a runtime is: libgomp ends the process when it is refused
// one, and TBB may wait for it for ever.
#pragma once

namespace pathrace::bench {

/// Starts that many threads at the same time, and ends them. Throws EnvironmentError when one is refused.
/// Cannot see that the system refuses later, what other processes take in between, or threads that a planner
/// starts by itself.
void require_threads(int count);

}  // namespace pathrace::bench
