#include "baselines/ompl/constraints.hpp"

#include <algorithm>
#include <cstdlib>
#include <string>

namespace pathrace::baselines {
namespace {

using Range = std::pair<double, double>;
using Rule = Condition<ParameterValues>;

constexpr double least_share = 1e-6;  // where the library wants more than 0

bool on(const ParameterValues& values, const std::string& name) {
  return values.at(name) == "true";
}

double number(const ParameterValues& values, const std::string& name) {
  return std::strtod(values.at(name).c_str(), nullptr);
}

Rule exclusive(const std::string& a, const std::string& b) {
  return {{{a, b}, a + " and " + b + " exclude each other"},
          [=](const ParameterValues& values) { return !on(values, a) || !on(values, b); }};
}

Rule ascending(const std::string& low, const std::string& high) {
  return {{{low, high}, low + " must be at most " + high},
          [=](const ParameterValues& values) { return number(values, low) <= number(values, high); }};
}

// focus_search switches informed sampling and tree pruning on.
const std::vector<Rule>& rules() {
  static const std::vector<Rule> rules = {
      exclusive("sample_rejection", "informed_sampling"),
      exclusive("sample_rejection", "focus_search"),
      {{{"ordered_sampling", "informed_sampling", "sample_rejection", "focus_search"},
        "ordered_sampling needs informed_sampling, sample_rejection or focus_search"},
       [](const ParameterValues& values) {
         return !on(values, "ordered_sampling") || on(values, "informed_sampling") ||
                on(values, "sample_rejection") || on(values, "focus_search");
       }},
      {{{"pruned_measure", "informed_sampling", "tree_pruning", "focus_search"},
        "pruned_measure needs informed_sampling and tree_pruning, or focus_search"},
       [](const ParameterValues& values) {
         return !on(values, "pruned_measure") || on(values, "focus_search") ||
                (on(values, "informed_sampling") && on(values, "tree_pruning"));
       }},
      {{{"drop_unconnected_samples_on_prune", "use_graph_pruning"},
        "drop_unconnected_samples_on_prune needs use_graph_pruning"},
       [](const ParameterValues& values) {
         return !on(values, "drop_unconnected_samples_on_prune") || on(values, "use_graph_pruning");
       }},
      // The library takes it only once use_k_nearest is off, which is set after it, and goes on without it.
      {{{"use_just_in_time_sampling"}, "use_just_in_time_sampling is not supported"},
       [](const ParameterValues& values) { return !on(values, "use_just_in_time_sampling"); }},
      ascending("min_degree", "degree"),
      ascending("degree", "max_degree"),
      ascending("dense_delta_fraction", "sparse_delta_fraction"),
  };
  return rules;
}

bool declares(const std::vector<DeclaredParameter>& declared, const std::string& name) {
  return std::any_of(declared.begin(), declared.end(),
                     [&](const DeclaredParameter& parameter) { return parameter.card.name == name; });
}

}  // namespace

// KPIECE, BKPIECE and LBKPIECE, which alone have a border, look for shares in (0, 1] in setup().
std::optional<Range> accepted_range(const ompl::base::ParamSet& parameters, std::string_view name) {
  const bool is_share = name == "border_fraction" || name == "failed_expansion_score_factor" ||
                        name == "min_valid_path_fraction";
  if (!is_share || !parameters.hasParam("border_fraction")) return std::nullopt;
  return Range{least_share, 1};
}

std::vector<Rule> conditions_on(const std::vector<DeclaredParameter>& declared) {
  std::vector<Rule> conditions;
  for (const Rule& rule : rules()) {
    const std::vector<std::string>& names = rule.card.parameters;
    const bool all = std::all_of(names.begin(), names.end(),
                                 [&](const std::string& name) { return declares(declared, name); });
    if (all) conditions.push_back(rule);
  }
  return conditions;
}

}  // namespace pathrace::baselines
