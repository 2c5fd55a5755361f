// How an exact search on the grid reports: work, trace and path.
#pragma once

#include <cstdint>

#include "core/meter.hpp"

namespace pathrace::baselines {

enum class Outcome { found, no_way, cut };

/// How often a search looks at the clock, in expansions.
inline constexpr std::uint64_t clock_interval = 4096;

/// One iteration for a search that ran to its end; no way is its last word.
inline void report(Outcome outcome, std::uint64_t expanded, Meter& meter) {
  meter.spend_checks(expanded);
  if (outcome == Outcome::cut) return;
  meter.end_iteration();
  if (outcome == Outcome::no_way) meter.conclude();
  if (outcome == Outcome::found) meter.spend_evaluations(1);
}

}  // namespace pathrace::baselines
