#include "results/leaderboard.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

#include "results/median.hpp"

namespace pathrace::results {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

using GroupKey = std::tuple<std::string, std::string, Track>;  // family or empty, label, track

/// What the trials of one standing add up to.
struct Sample {
  std::uint64_t trials = 0;
  std::uint64_t solved = 0;
  std::vector<double> gaps;  ///< of trials with a reference, infinite where they failed
  std::vector<double> solved_gaps;
  std::vector<double> lengths;
  std::vector<double> turns;
  std::vector<double> evaluations;
  std::vector<double> checks;
  std::vector<double> times_ms;
  bool crowded = false;
};

void add_solved(const TrialRow& row, Sample& sample) {
  ++sample.solved;
  if (row.gap) sample.solved_gaps.push_back(*row.gap);
  if (row.length) sample.lengths.push_back(*row.length);
  if (row.turns) sample.turns.push_back(*row.turns);
}

void add(const TrialRow& row, Sample& sample) {
  const bool solved = row.verdict == Verdict::solved;
  ++sample.trials;
  if (solved) add_solved(row, sample);
  if (row.optimum) sample.gaps.push_back(solved ? row.gap.value_or(infinite) : infinite);
  sample.evaluations.push_back(static_cast<double>(row.work.evaluations));
  sample.checks.push_back(static_cast<double>(row.work.checks));
  sample.times_ms.push_back(row.costs.wall_s * 1000);
  sample.crowded = sample.crowded || row.costs.crowded;
}

std::optional<double> finite_median(std::vector<double> sample) {
  if (sample.empty()) return std::nullopt;
  const double middle = median(std::move(sample));
  return std::isfinite(middle) ? std::optional(middle) : std::nullopt;
}

Standing standing_of(const GroupKey& key, Sample&& sample) {
  Standing standing;
  std::tie(standing.group, standing.planner, standing.track) = key;
  standing.trials = sample.trials;
  standing.solved = sample.solved;
  standing.success = static_cast<double>(sample.solved) / static_cast<double>(sample.trials);
  standing.gap_median = finite_median(std::move(sample.gaps));
  standing.gap_solved = finite_median(std::move(sample.solved_gaps));
  standing.length_median = finite_median(std::move(sample.lengths));
  standing.turns_median = finite_median(std::move(sample.turns));
  standing.evaluations_median = finite_median(std::move(sample.evaluations));
  standing.checks_median = finite_median(std::move(sample.checks));
  standing.time_ms_median = finite_median(std::move(sample.times_ms));
  standing.crowded = sample.crowded;
  return standing;
}

// Smaller is better; what is missing comes last.
std::tuple<double, double, double> merit(const Standing& standing) {
  return {-standing.success, standing.gap_median.value_or(infinite), standing.gap_solved.value_or(infinite)};
}

bool before(const Standing& a, const Standing& b) {
  if (a.group != b.group) return a.group < b.group;
  if (merit(a) != merit(b)) return merit(a) < merit(b);
  return std::tie(a.planner, a.track) < std::tie(b.planner, b.track);
}

void rank(std::vector<Standing>& standings) {
  std::sort(standings.begin(), standings.end(), before);
  int place = 0;
  for (std::size_t i = 0; i < standings.size(); ++i) {
    const bool first = i == 0 || standings[i].group != standings[i - 1].group;
    place = first ? 1 : place + 1;
    const bool tied = !first && merit(standings[i]) == merit(standings[i - 1]);
    standings[i].rank = tied ? standings[i - 1].rank : place;
  }
}

}  // namespace

std::string family_of(const std::string& scenario) {
  return scenario.substr(0, scenario.find('/'));
}

std::vector<Standing> leaderboard(const Store& store, Grouping grouping) {
  std::map<GroupKey, Sample> samples;
  store.for_each_slim([&](const TrialRow& row) {
    const std::string group = grouping == Grouping::family ? family_of(row.scenario) : "";
    add(row, samples[GroupKey(group, row.planner, row.track)]);
  });
  std::vector<Standing> standings;
  standings.reserve(samples.size());
  for (auto& [key, sample] : samples) standings.push_back(standing_of(key, std::move(sample)));
  rank(standings);
  return standings;
}

}  // namespace pathrace::results
