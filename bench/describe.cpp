#include "bench/describe.hpp"

#include <algorithm>
#include <set>
#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

#include "bench/executors.hpp"
#include "bench/features/feature.hpp"
#include "bench/reference.hpp"

namespace pathrace::bench {
namespace {

constexpr std::size_t scenarios_per_job = 8;  // between two transactions

bool has_every_feature(const results::ScenarioRow& row) {
  std::set<std::string_view> names;
  for (const results::FeatureValue& feature : row.features) names.insert(feature.name);
  return std::all_of(features().begin(), features().end(),
                     [&names](const Feature& feature) { return names.count(feature.name) > 0; });
}

std::vector<const Scenario*> missing_scenarios(const TrialPlan& plan, bool with_features,
                                               const results::Store& store) {
  std::unordered_set<std::string> known;
  store.for_each_scenario([&](const results::ScenarioRow& row) {
    if (!with_features || has_every_feature(row)) known.insert(row.id);
  });
  std::vector<const Scenario*> missing;
  for (const Scenario& scenario : plan.scenarios) {
    if (known.count(scenario.id) == 0) missing.push_back(&scenario);
  }
  return missing;
}

// Rows are stored in the plan's order without holes.
void drop_what_was_not_done(std::vector<results::ScenarioRow>& rows) {
  const auto first =
      std::find_if(rows.begin(), rows.end(), [](const results::ScenarioRow& row) { return row.id.empty(); });
  rows.erase(first, rows.end());
}

}  // namespace

results::ScenarioRow describe(Scenario scenario, bool with_features) {
  const Referee referee(scenario.terrain);
  prove_reference(scenario, Track::lattice, referee);
  prove_reference(scenario, Track::any_angle, referee);
  results::ScenarioRow row = results::make_scenario_row(scenario);
  if (!with_features) return row;
  const std::vector<std::optional<double>> values = compute_features(scenario);
  for (std::size_t i = 0; i < values.size(); ++i) {
    row.features.push_back({std::string(features()[i].name), values[i]});
  }
  return row;
}

std::size_t store_scenarios(const TrialPlan& plan, bool with_features, const RunOptions& options,
                            const std::atomic<bool>& stop, results::Store& store) {
  const std::vector<const Scenario*> missing = missing_scenarios(plan, with_features, store);
  const std::unique_ptr<Executor> across = make_executor(options.backend, options.jobs);
  const std::size_t batch = scenarios_per_job * static_cast<std::size_t>(options.jobs);
  std::size_t described = 0;
  while (described < missing.size() && !stop.load()) {
    std::vector<results::ScenarioRow> rows(std::min(batch, missing.size() - described));
    for_each_index(*across, rows.size(), 1, [&](std::size_t i) {
      if (!stop.load()) rows[i] = describe(*missing[described + i], with_features);
    });
    drop_what_was_not_done(rows);
    store.describe(rows);
    described += rows.size();
  }
  return described;
}

}  // namespace pathrace::bench
