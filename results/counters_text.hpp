// What a planner counted, as text: "name=value" per counter, blanks between.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/meter.hpp"

namespace pathrace::results {

std::string print_counters(const std::vector<Counter>& counters);
/// The reverse. Throws InputError on anything else.
std::vector<Counter> parse_counters(std::string_view text);

}  // namespace pathrace::results
