// Processors that a thread may run on.
#pragma once

#include <sched.h>
#include <sys/types.h>

#include <set>

namespace pathrace::testing {

using Processors = std::set<int>;

/// Of this thread, by default the calling one; none when it has ended.
inline Processors allowed_processors(pid_t thread = 0) {
  cpu_set_t set;
  CPU_ZERO(&set);
  if (sched_getaffinity(thread, sizeof set, &set) != 0) return {};
  Processors processors;
  for (int k = 0; k < CPU_SETSIZE; ++k) {
    if (CPU_ISSET(k, &set)) processors.insert(k);
  }
  return processors;
}

}  // namespace pathrace::testing
