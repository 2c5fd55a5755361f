#include "bench/failure_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace pathrace::bench {
namespace {

using Counts = std::map<std::string, std::uint64_t>;  // trials by planner

constexpr std::size_t named_planners = 4;

// "7 (a 4, b 2, c 1)", those with the most trials first.
std::string sum_and_names(const Counts& counts) {
  std::vector<std::pair<std::string, std::uint64_t>> order(counts.begin(), counts.end());
  std::stable_sort(order.begin(), order.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  std::uint64_t sum = 0;
  std::string names;
  for (std::size_t i = 0; i < order.size(); ++i) {
    sum += order[i].second;
    if (i < named_planners)
      names += fmt::format("{}{} {}", i == 0 ? "" : ", ", order[i].first, order[i].second);
  }
  if (order.size() > named_planners) names += fmt::format(" and {} more", order.size() - named_planners);
  return fmt::format("{} ({})", sum, names);
}

}  // namespace

std::vector<std::string> failure_lines(const std::vector<results::OutcomeCount>& outcomes) {
  std::map<Verdict, Counts> failures;
  Counts false_claims;
  for (const results::OutcomeCount& outcome : outcomes) {
    const bool gave_up = outcome.verdict == Verdict::gave_up;
    if (gave_up || is_fault(outcome.verdict)) failures[outcome.verdict][outcome.planner] += outcome.trials;
    if (gave_up && outcome.noted) false_claims[outcome.planner] += outcome.trials;
  }
  std::vector<std::string> lines;
  if (!failures.empty()) {
    std::string line = "trials without a result:";
    for (const auto& [verdict, counts] : failures) {
      line += fmt::format("{} {} {}", line.ends_with(':') ? "" : ",", results::in_words(verdict),
                          sum_and_names(counts));
    }
    lines.push_back(std::move(line));
  }
  if (!false_claims.empty()) {
    lines.push_back("warning: claims that there is no way where one is proven: " +
                    sum_and_names(false_claims));
  }
  return lines;
}

}  // namespace pathrace::bench
