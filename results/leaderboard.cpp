#include "results/leaderboard.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
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
  std::vector<double> steps;
  std::vector<double> min_clearances;
  std::vector<double> oscillations;
  std::vector<double> collisions;
  std::vector<double> struck;
  std::vector<double> step_ms;
  std::vector<double> step_ms_p99;
  std::uint64_t gave_up = 0;
  std::uint64_t crashed = 0;
  std::uint64_t invalid = 0;
  bool crowded = false;
};

void add_solved(const TrialRow& row, Sample& sample) {
  ++sample.solved;
  if (row.gap) sample.solved_gaps.push_back(*row.gap);
  if (row.length) sample.lengths.push_back(*row.length);
  if (row.turns) sample.turns.push_back(*row.turns);
}

void add_failure(const TrialRow& row, Sample& sample) {
  sample.gave_up += row.verdict == Verdict::gave_up;
  sample.crashed += row.verdict == Verdict::crashed;
  sample.invalid += row.verdict == Verdict::invalid;
}

void add_run(const TrialRow& row, Sample& sample) {
  if (row.costs.step_ms_median) sample.step_ms.push_back(*row.costs.step_ms_median);
  if (row.costs.step_ms_p99) sample.step_ms_p99.push_back(*row.costs.step_ms_p99);
  if (!row.run) return;
  sample.collisions.push_back(static_cast<double>(row.run->collisions));
  sample.struck.push_back(static_cast<double>(row.run->struck));
  if (row.verdict != Verdict::solved) return;
  sample.steps.push_back(static_cast<double>(row.run->steps));
  sample.oscillations.push_back(static_cast<double>(row.run->oscillations));
  if (row.run->min_clearance) sample.min_clearances.push_back(*row.run->min_clearance);
}

void add(const TrialRow& row, Sample& sample) {
  const bool solved = row.verdict == Verdict::solved;
  ++sample.trials;
  solved ? add_solved(row, sample) : add_failure(row, sample);
  add_run(row, sample);
  if (row.optimum || row.least_steps) sample.gaps.push_back(solved ? row.gap.value_or(infinite) : infinite);
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

std::optional<double> mean(const std::vector<double>& sample) {
  if (sample.empty()) return std::nullopt;
  return std::accumulate(sample.begin(), sample.end(), 0.0) / static_cast<double>(sample.size());
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
  standing.steps_median = finite_median(std::move(sample.steps));
  standing.min_clearance_median = finite_median(std::move(sample.min_clearances));
  standing.oscillations_median = finite_median(std::move(sample.oscillations));
  standing.collisions_mean = mean(sample.collisions);
  standing.struck_mean = mean(sample.struck);
  standing.step_ms_median = finite_median(std::move(sample.step_ms));
  standing.step_ms_p99_median = finite_median(std::move(sample.step_ms_p99));
  standing.gave_up = sample.gave_up;
  standing.crashed = sample.crashed;
  standing.invalid = sample.invalid;
  standing.crowded = sample.crowded;
  return standing;
}

// Smaller is better; what is missing comes last.
std::tuple<double, double, double> merit(const Standing& standing) {
  return {-standing.success, standing.gap_median.value_or(infinite), standing.gap_solved.value_or(infinite)};
}

// What is ranked together.
std::tuple<const std::string&, Track> block(const Standing& standing) {
  return {standing.group, standing.track};
}

bool before(const Standing& a, const Standing& b) {
  if (block(a) != block(b)) return block(a) < block(b);
  if (merit(a) != merit(b)) return merit(a) < merit(b);
  return a.planner < b.planner;
}

void rank(std::vector<Standing>& standings) {
  std::sort(standings.begin(), standings.end(), before);
  int place = 0;
  for (std::size_t i = 0; i < standings.size(); ++i) {
    const bool first = i == 0 || block(standings[i]) != block(standings[i - 1]);
    place = first ? 1 : place + 1;
    const bool tied = !first && merit(standings[i]) == merit(standings[i - 1]);
    standings[i].rank = tied ? standings[i - 1].rank : place;
  }
}

// "12,40"
bool is_cell(std::string_view text) {
  return text.find(',') != std::string_view::npos &&
         text.find_first_not_of("0123456789,") == std::string_view::npos;
}

}  // namespace

std::string family_of(std::string_view scenario) {
  std::string_view family = scenario.substr(0, scenario.rfind('/'));
  while (true) {
    const std::size_t slash = family.rfind('/');
    if (slash == std::string_view::npos || !is_cell(family.substr(slash + 1))) return std::string(family);
    family = family.substr(0, slash);
  }
}

std::vector<Standing> leaderboard(const Store& store, Grouping grouping) {
  std::map<GroupKey, Sample> samples;
  store.for_each_slim([&](const TrialRow& row) {
    if (row.draws == false && row.repetition > 0) return;  // the same trial again
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
