#include <cmath>

#include "bench/features/feature.hpp"

namespace pathrace::bench {
namespace {

std::optional<double> detour(FeatureContext& context) {
  const Scenario& scenario = context.scenario();
  const std::optional<LatticeLength> optimum = context.optimum();
  if (!optimum || scenario.start == scenario.goal) return std::nullopt;
  const double dx = scenario.goal.x - scenario.start.x;
  const double dy = scenario.goal.y - scenario.start.y;
  return optimum->value() / std::sqrt(dx * dx + dy * dy);
}

}  // namespace

Feature detour_feature() {
  return {"detour", "ratio", "optimum / straight-line distance from start to goal", FeatureType::real,
          detour};
}

}  // namespace pathrace::bench
