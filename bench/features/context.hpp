// What the features of one scenario share: each expensive part is made when first asked for, and once.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "core/catalogue.hpp"
#include "core/executor.hpp"
#include "core/moves.hpp"
#include "core/record.hpp"
#include "core/referee.hpp"
#include "core/reference/distance_field.hpp"
#include "core/scenario.hpp"
#include "core/stream.hpp"

namespace pathrace::bench {

/// For one thread at a time. The scenario outlives it.
class FeatureContext {
 public:
  explicit FeatureContext(const Scenario& scenario);

  const Scenario& scenario() const { return scenario_; }
  /// The length of a shortest path; nothing when there is no way.
  std::optional<LatticeLength> optimum();
  /// Exact distances from the start, final for every cell nearer than the goal by a step or more, and for the
  /// goal: what shortest paths are made of.
  const reference::DistanceField& from_start();
  const MoveTable& moves();
  /// The trial of A* on this scenario, without a limit.
  const TrialRecord& astar();

  /// A trial of an entrant on this scenario, judged, on one thread.
  TrialRecord run(const Entrant& entrant, const Budget& budget, const Stream& stream);
  /// For a feature that draws: depends on the scenario's id alone, not on any campaign.
  Stream stream(std::string_view feature) const;

 private:
  const Scenario& scenario_;
  std::unique_ptr<Executor> executor_;
  std::unique_ptr<reference::DistanceField> from_start_;
  std::unique_ptr<MoveTable> moves_;
  std::unique_ptr<Referee> referee_;
  std::optional<TrialRecord> astar_;
};

}  // namespace pathrace::bench
