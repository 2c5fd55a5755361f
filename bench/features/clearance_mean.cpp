#include "bench/features/feature.hpp"

namespace pathrace::bench {
namespace {

std::optional<double> clearance_mean(FeatureContext& context) {
  const TrialRecord& record = context.astar();
  if (!record.metrics) return std::nullopt;
  return record.metrics->clearance_mean;
}

}  // namespace

Feature clearance_mean_feature() {
  return {"clearance_mean", "cells", "mean distance to a blocked cell's centre along the path of A*",
          FeatureType::real, clearance_mean};
}

}  // namespace pathrace::bench
