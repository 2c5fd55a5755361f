// One trial in a dynamic world: let a navigator steer, have the run judged, write the record.
#pragma once

#include <functional>

#include "core/catalogue.hpp"
#include "core/executor.hpp"
#include "core/record.hpp"
#include "core/world.hpp"

namespace pathrace::bench {

class Ticker;

/// Called after each step, with what the navigator saw, where it goes, and what it drew.
using WatchStep = std::function<void(const Snapshot&, Point next, const Overlay&)>;

/// The navigator's stream in step k is stream.fork(k); iterations are steps; the trace is the distance to the
/// goal after each step that made it least.
///
/// Verdicts: `solved`, arrived without a collision of the robot's own; `invalid`, arrived with collisions, or
/// the rules were broken; `budget`, not arrived after max_steps, or the budget ended first; `unsupported`, a
/// planner of static maps. Nothing a navigator does comes out as an exception. `key` and the costs that
/// describe the executor are the caller's to fill in.
TrialRecord run_dynamic_trial(const Entrant& entrant, const World& world, const Budget& budget,
                              const Stream& stream, Executor& executor, const WatchStep& watch = {},
                              Ticker* ticker = nullptr);

}  // namespace pathrace::bench
