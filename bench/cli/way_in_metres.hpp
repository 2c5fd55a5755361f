// An answer of `plan` in the frame of the map file, in metres.
#pragma once

#include "core/scenario.hpp"
#include "results/json.hpp"
#include "results/row.hpp"
#include "scenarios/ros/map_frame.hpp"

namespace pathrace::bench::cli {

results::InMetres in_metres(const scenarios::MapFrame& frame, const Scenario& scenario,
                            const results::TrialRow& row);

/// Length, turns, clearance, both ends, and the points where the way turns.
void print_way_in_metres(const results::TrialRow& row, const results::InMetres& metres);

}  // namespace pathrace::bench::cli
