#include "bench/features/feature.hpp"

namespace pathrace::bench {
namespace {

std::optional<double> clearance_min(FeatureContext& context) {
  const TrialRecord& record = context.astar();
  if (!record.metrics) return std::nullopt;
  return record.metrics->clearance_min;
}

}  // namespace

Feature clearance_min_feature() {
  return {"clearance_min", "cells", "least distance to a blocked cell's centre along the path of A*",
          FeatureType::real, clearance_min};
}

}  // namespace pathrace::bench
