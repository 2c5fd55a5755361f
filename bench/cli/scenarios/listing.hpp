// The ways in which `scenarios list` prints what it found.
#pragma once

#include <vector>

#include "results/scenario_row.hpp"

namespace pathrace::bench::cli {

/// A JSON array; an object `features` in each element when asked for.
void print_json(const std::vector<results::ScenarioRow>& rows, bool with_features);
/// The columns of scenarios.csv.
void print_csv(const std::vector<results::ScenarioRow>& rows, bool with_features);
/// Size, rule, optimum and hash; with features, those in place of rule and hash.
void print_table(const std::vector<results::ScenarioRow>& rows, bool with_features);

}  // namespace pathrace::bench::cli
