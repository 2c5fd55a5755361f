#include "bench/reference.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "bench/executors.hpp"
#include "bench/roster.hpp"
#include "bench/trial.hpp"
#include "core/record.hpp"
#include "scenarios/library.hpp"

namespace pathrace::bench {
namespace {

AnyAngleOptimum any_angle_optimum(const Scenario& scenario, const Referee& referee) {
  static const Entrant search = roster().enter({"any-angle-optimum", {}});
  const std::unique_ptr<Executor> executor = make_executor("serial", 1);
  const TrialRecord record = run_trial(search, scenario, referee, Budget{}, Stream(0), *executor);
  if (record.verdict == Verdict::solved) return {true, record.metrics->length};
  if (record.verdict == Verdict::no_path) return {true, std::nullopt};
  throw std::logic_error(
      fmt::format("{}: no any-angle reference: {}: {}", scenario.id, name(record.verdict), record.note));
}

}  // namespace

void prove_reference(Scenario& scenario, Track track, const Referee& referee) {
  if (scenario.world) return;
  switch (track) {
    case Track::lattice: scenarios::prove(scenario); break;
    case Track::any_angle:
      if (!scenario.any_angle_optimum.proven) {
        scenario.any_angle_optimum = any_angle_optimum(scenario, referee);
      }
      break;
    case Track::dynamic: break;
  }
}

}  // namespace pathrace::bench
