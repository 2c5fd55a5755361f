// The anytime trace of one trial as CSV: each improvement with the work and time spent until then.
#pragma once

#include <ostream>
#include <vector>

#include "core/meter.hpp"

namespace pathrace::results {

/// Header `evaluations,iterations,checks,wall_s,length`; the length is the incumbent's cost, in cells.
void write_trace_csv(std::ostream& out, const std::vector<TracePoint>& trace);

}  // namespace pathrace::results
