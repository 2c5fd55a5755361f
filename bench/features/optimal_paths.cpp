#include "bench/features/feature.hpp"
#include "bench/features/path_count.hpp"

namespace pathrace::bench {
namespace {

std::optional<double> optimal_paths_log10(FeatureContext& context) {
  if (!context.optimum()) return std::nullopt;
  const Scenario& scenario = context.scenario();
  return count_shortest_paths(context.from_start(), scenario.grid(), scenario.goal).log10();
}

}  // namespace

Feature optimal_paths_feature() {
  return {"optimal_paths_log10", "log10 of paths", "how many paths are optimal", FeatureType::real,
          optimal_paths_log10};
}

}  // namespace pathrace::bench
