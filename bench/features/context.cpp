#include "bench/features/context.hpp"

#include "bench/executors.hpp"
#include "bench/roster.hpp"
#include "bench/trial.hpp"

namespace pathrace::bench {

FeatureContext::FeatureContext(const Scenario& scenario)
    : scenario_(scenario), executor_(make_executor("serial", 1)) {}

std::optional<LatticeLength> FeatureContext::optimum() {
  return scenario_.optimum.proven ? scenario_.optimum.length : from_start().length(scenario_.goal);
}

const reference::DistanceField& FeatureContext::from_start() {
  if (!from_start_) {
    from_start_ =
        std::make_unique<reference::DistanceField>(scenario_.terrain, scenario_.start, scenario_.goal);
  }
  return *from_start_;
}

const MoveTable& FeatureContext::moves() {
  if (!moves_) moves_ = std::make_unique<MoveTable>(scenario_.grid(), scenario_.terrain.rule);
  return *moves_;
}

const TrialRecord& FeatureContext::astar() {
  if (!astar_) {
    static const Entrant entrant = roster().enter({"astar", {}});
    astar_ = run(entrant, Budget{}, stream("astar"));
  }
  return *astar_;
}

TrialRecord FeatureContext::run(const Entrant& entrant, const Budget& budget, const Stream& stream) {
  if (!referee_) referee_ = std::make_unique<Referee>(scenario_.terrain);
  return run_trial(entrant, scenario_, *referee_, budget, stream, *executor_);
}

Stream FeatureContext::stream(std::string_view feature) const {
  return root_stream(0, scenario_.id, 0).fork("feature").fork(feature);
}

}  // namespace pathrace::bench
