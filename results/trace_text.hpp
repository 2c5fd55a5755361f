// The anytime trace as text: "evaluations,iterations,checks,wall_s,cost" per improvement, blanks between.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/meter.hpp"

namespace pathrace::results {

std::string print_trace(const std::vector<TracePoint>& trace);
/// The reverse, bit for bit. Throws InputError on anything else.
std::vector<TracePoint> parse_trace(std::string_view text);

}  // namespace pathrace::results
