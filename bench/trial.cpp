#include "bench/trial.hpp"

#include <fmt/format.h>

#include <chrono>

#include "bench/dynamic_trial.hpp"
#include "bench/guarded.hpp"
#include "bench/ticker.hpp"
#include "bench/trial_surroundings.hpp"
#include "core/checkpoint.hpp"
#include "core/error.hpp"
#include "core/gap.hpp"

namespace pathrace::bench {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

void call_planner(const Entrant& entrant, const Scenario& scenario, const Terrain& map, Context& context,
                  TrialRecord& record) {
  const Clock::time_point begin = Clock::now();
  guarded(record, [&] {
    const TrialScope scope(context.meter);
    if (entrant.card->navigates()) throw Unsupported("navigates among moving discs; this map stands still");
    const std::unique_ptr<MapPlanner> planner = entrant.card->make(entrant.values)(map);
    record.costs.setup_s = seconds_since(begin);
    record.answer = planner->plan(scenario.start, scenario.goal, context);
    record.verdict = Verdict::solved;
  });
  record.costs.wall_s = seconds_since(begin);
}

// An empty answer is a spent budget, a proof that there is no way, or neither.
void judge_empty(const Entrant& entrant, const Scenario& scenario, const Meter& meter, TrialRecord& record) {
  const bool complete = entrant.card->complete_search;
  const bool claims = meter.concluded() || (complete && !meter.spent());
  const Proof proof = proof_of(scenario, entrant.card->track);
  if (!claims && meter.spent()) {
    record.verdict = Verdict::budget;
  } else if (proof == Proof::no_way || (proof == Proof::none && claims)) {
    record.verdict = Verdict::no_path;
  } else {
    record.verdict = claims && complete ? Verdict::invalid : Verdict::gave_up;
    if (claims) {
      record.note = fmt::format("{} claims that there is no way; the proven optimum is {}", entrant.label,
                                *reference_length(scenario, entrant.card->track));
    }
  }
}

void judge(const Entrant& entrant, const Scenario& scenario, const Referee& referee, const Meter& meter,
           TrialRecord& record) {
  if (record.verdict != Verdict::solved) return;
  if (meter.exceeded()) {
    record.verdict = Verdict::invalid;
    record.note = fmt::format("the budget was exceeded: {} evaluations, {} iterations, {} checks",
                              record.work.evaluations, record.work.iterations, record.work.checks);
    return;
  }
  if (!record.answer) return judge_empty(entrant, scenario, meter, record);
  if (record.answer->track != entrant.card->track) {
    record.verdict = Verdict::invalid;
    record.note = fmt::format("answered on the track {}, races on {}", name(record.answer->track),
                              name(entrant.card->track));
    return;
  }
  Judgement judgement = referee.judge(*record.answer, scenario.start, scenario.goal);
  record.note = judgement.legal() ? contradiction(*judgement.metrics, scenario, record.answer->track)
                                  : std::move(judgement.fault);
  if (record.note.empty()) {
    record.metrics = judgement.metrics;
  } else {
    record.verdict = Verdict::invalid;
  }
}

}  // namespace

TrialRecord run_trial(const Entrant& entrant, const Scenario& scenario, const Referee& referee,
                      const Budget& budget, const Stream& stream, Executor& executor, Overlay* overlay,
                      Ticker* ticker, bool check_map) {
  if (scenario.world) return run_dynamic_trial(entrant, *scenario.world, budget, stream, executor);
  TrialRecord record;
  Meter meter(budget);
  const Ticker::Watch watch(ticker, meter);
  Context context{stream, executor, meter, overlay};
  executor.restart_census();
  const MapLoan loan(scenario.terrain, check_map);
  {
    const TrialSurroundings surroundings(executor, record.costs);
    executor.with_team([&] { call_planner(entrant, scenario, loan.terrain(), context, record); });
  }
  if (meter.interrupted()) throw Interrupted();
  record.work = meter.work();
  record.trace = meter.trace();
  record.counters = meter.counters();
  record.timed = meter.timed() || !entrant.card->deterministic;
  record.costs.threads_used = executor.threads_used();
  judge(entrant, scenario, referee, meter, record);
  if (!loan.intact()) {
    record.verdict = Verdict::invalid;
    record.note = "the planner changed the map that it was lent";
    record.metrics.reset();
  }
  return record;
}

}  // namespace pathrace::bench
