// A scenario as it is stored and printed: the question, and the features that were computed for it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/scenario.hpp"

namespace pathrace::results {

struct FeatureValue {
  std::string name;
  std::optional<double> value;  ///< empty: computed, and the scenario has none

  friend bool operator==(const FeatureValue&, const FeatureValue&) = default;
};

struct ScenarioRow {
  std::string id;
  int width = 0;   ///< cells
  int height = 0;  ///< cells
  MoveRule rule = MoveRule::strict;
  Cell start;
  Cell goal;
  std::optional<double> optimum;            ///< cells; empty where none is proven or there is no way
  std::optional<double> any_angle_optimum;  ///< the same among any-angle paths
  std::uint64_t hash = 0;                   ///< of the question, whatever it is called
  std::vector<FeatureValue> features;

  std::string_view family() const { return std::string_view(id).substr(0, id.find('/')); }

  friend bool operator==(const ScenarioRow&, const ScenarioRow&) = default;
};

/// Without features.
ScenarioRow make_scenario_row(const Scenario& scenario);

}  // namespace pathrace::results
