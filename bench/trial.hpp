// One trial: run a planner on a scenario, have the answer judged, write the record.
#pragma once

#include "bench/map_loan.hpp"
#include "core/catalogue.hpp"
#include "core/executor.hpp"
#include "core/record.hpp"
#include "core/referee.hpp"
#include "core/scenario.hpp"

namespace pathrace::bench {

class Ticker;

/// Nothing a planner does comes out as an exception: it becomes the record's verdict. `key` and the costs
/// that describe the executor are the caller's to fill in. `overlay`: for a picture of what the planner
/// thinks. `check_map`: the planner gets a copy of the map, and is `invalid` when it changes that. Throws
/// Interrupted when the process is asked to stop and the planner was cut by that.
///
/// A legal path that beats what is proven about the scenario is `invalid`: somebody errs, and nobody shall
/// win by it. An empty answer is `budget` when the budget is spent, and `no_path` when it is a proof: the
/// scenario's, the planner's own (Meter::conclude), or the end of a complete search. Without either it is
/// `gave_up`. A claim that there is no way against a proven optimum is `gave_up` with a note, and `invalid`
/// for a complete search.
TrialRecord run_trial(const Entrant& entrant, const Scenario& scenario, const Referee& referee,
                      const Budget& budget, const Stream& stream, Executor& executor,
                      Overlay* overlay = nullptr, Ticker* ticker = nullptr,
                      bool check_map = maps_are_checked);

}  // namespace pathrace::bench
