#include "bench/features/feature.hpp"

namespace pathrace::bench {

#define PATHRACE_FEATURE(feature) Feature feature();
#include "bench/features/features.def"
#undef PATHRACE_FEATURE

const std::vector<Feature>& features() {
  static const std::vector<Feature> all = {
#define PATHRACE_FEATURE(feature) feature(),
#include "bench/features/features.def"
#undef PATHRACE_FEATURE
  };
  return all;
}

std::vector<std::optional<double>> compute_features(const Scenario& scenario) {
  if (scenario.world) return std::vector<std::optional<double>>(features().size());  // they speak of maps
  FeatureContext context(scenario);
  std::vector<std::optional<double>> values;
  values.reserve(features().size());
  for (const Feature& feature : features()) values.push_back(feature.compute(context));
  return values;
}

}  // namespace pathrace::bench
