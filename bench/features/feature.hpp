// Features: figures that say how hard a scenario is, before anybody races on it.
//
// One feature = one file in this folder and one line in features.def.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "bench/features/context.hpp"

namespace pathrace::bench {

enum class FeatureType { real, integer };

struct Feature {
  std::string_view name;     ///< of its column
  std::string_view unit;     ///< "cells", "share", ...
  std::string_view meaning;  ///< one line
  FeatureType type = FeatureType::real;
  /// The value, a whole number below 2^53 where the type is integer; nothing where the scenario has none. A
  /// function of the scenario alone: the same bits on every backend, number of threads and compiler.
  std::optional<double> (*compute)(FeatureContext& context) = nullptr;
};

/// In the order of features.def.
const std::vector<Feature>& features();

/// The value of every feature, in the same order.
std::vector<std::optional<double>> compute_features(const Scenario& scenario);

}  // namespace pathrace::bench
