#include "results/row.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/error.hpp"
#include "core/gap.hpp"
#include "core/hash.hpp"
#include "results/number_text.hpp"
#include "results/quote.hpp"
#include "results/split.hpp"

namespace pathrace::results {
namespace {

void copy_metrics(const PathMetrics& metrics, const Scenario& scenario, TrialRow& row) {
  row.length = metrics.length;
  row.gap = gap(metrics, scenario, row.track);
  row.turns = metrics.turns;
  row.turn_angle = metrics.turn_angle;
  row.clearance_min = metrics.clearance_min;
  row.clearance_mean = metrics.clearance_mean;
}

// No run takes fewer steps than the informed pursuit; where that takes none, neither does the run.
std::optional<double> gap(const RunMetrics& run, std::optional<std::uint64_t> least_steps) {
  if (!least_steps) return std::nullopt;
  if (*least_steps == 0) return 0.0;
  return static_cast<double>(run.steps) / static_cast<double>(*least_steps) - 1;
}

void copy_run(const TrialRecord& record, const World& world, TrialRow& row) {
  row.run = record.run;
  row.least_steps = world.least_steps;
  if (record.verdict != Verdict::solved || !record.run) return;
  row.length = record.run->travelled;
  row.gap = gap(*record.run, world.least_steps);
}

Point parse_point(std::string_view text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string_view::npos)
    throw InputError(fmt::format("expected a point 'x,y', got {}", quoted(text)));
  return {parse_number(text.substr(0, comma)), parse_number(text.substr(comma + 1))};
}

}  // namespace

TrialRow make_row(const TrialKey& key, const Scenario& scenario, const Entrant& entrant, const Budget& budget,
                  const TrialRecord& record) {
  TrialRow row;
  row.key = key.hash();
  row.scenario = scenario.id;
  row.planner = entrant.label;
  row.call = entrant.full_call();
  row.version = entrant.version();
  row.repetition = key.repetition;
  row.seed = key.seed;
  row.budget = to_string(budget);
  row.verdict = record.verdict;
  row.note = record.note;
  row.track = entrant.card->track;
  row.rule = scenario.terrain.rule;
  row.draws = entrant.draws();
  row.optimum = reference_length(scenario, row.track);
  if (record.verdict == Verdict::solved && record.metrics) copy_metrics(*record.metrics, scenario, row);
  if (scenario.world) copy_run(record, *scenario.world, row);
  row.work = record.work;
  row.digest = digest(record);
  row.timed = record.timed;
  row.costs = record.costs;
  row.answer = record.answer;
  row.trace = record.trace;
  row.counters = record.counters;
  return row;
}

std::uint64_t recomputed_digest(const TrialRow& row) {
  TrialRecord record;
  record.verdict = row.verdict;
  record.answer = row.answer;
  record.work = row.work;
  record.trace = row.trace;
  return digest(record);
}

namespace {

// Stores keep no NaN: it comes back as no value.
void add(Hasher& hasher, const std::optional<double>& value) {
  const bool known = value && !std::isnan(*value);
  hasher.add(std::uint64_t{known ? 1U : 0U});
  if (known) hasher.add(*value);
}
template <typename T>
void add(Hasher& hasher, const std::optional<T>& value) {
  hasher.add(std::uint64_t{value ? 1U : 0U});
  if (value) hasher.add(static_cast<std::uint64_t>(*value));
}

void add(Hasher& hasher, const RunMetrics& run) {
  hasher.add(run.steps).add(run.travelled).add(run.collisions).add(run.struck);
  add(hasher, run.min_clearance);
  hasher.add(run.oscillations).add(run.world_hash);
}

void add(Hasher& hasher, const Costs& costs) {
  hasher.add(costs.wall_s).add(costs.setup_s).add(std::string_view(costs.backend));
  hasher.add(costs.threads).add(costs.threads_used).add(int{costs.crowded});
  for (const auto* time : {&costs.step_ms_median, &costs.step_ms_p99, &costs.user_s, &costs.system_s}) {
    add(hasher, *time);
  }
}

}  // namespace

std::uint64_t checksum(const TrialRow& row) {
  Hasher hasher;
  for (const std::string* text : {&row.scenario, &row.planner, &row.call, &row.budget, &row.note}) {
    hasher.add(std::string_view(*text));
  }
  hasher.add(row.key).add(row.version).add(row.repetition).add(row.seed);
  hasher.add(name(row.verdict)).add(name(row.track)).add(name(row.rule));
  for (const auto* metric :
       {&row.length, &row.optimum, &row.gap, &row.turn_angle, &row.clearance_min, &row.clearance_mean}) {
    add(hasher, *metric);
  }
  add(hasher, row.turns);
  hasher.add(row.work.evaluations).add(row.work.iterations).add(row.work.checks);
  hasher.add(row.digest).add(int{row.timed}).add(std::uint64_t{row.run ? 1U : 0U});
  if (row.run) add(hasher, *row.run);
  add(hasher, row.least_steps);
  add(hasher, row.costs);
  hasher.add(row.session);
  add(hasher, row.draws);
  return hasher.value();
}

std::uint64_t checksum(const std::vector<std::optional<std::string_view>>& texts) {
  Hasher hasher;
  for (const auto& text : texts) hasher.add(std::uint64_t{text ? 1U : 0U}).add(text.value_or(""));
  return hasher.value();
}

std::string print_points(const Path& path) {
  std::string text;
  for (const Point point : path.points) {
    if (!text.empty()) text += ' ';
    append_number(text, point.x);
    text += ',';
    append_number(text, point.y);
  }
  return text;
}

std::vector<Point> parse_points(std::string_view text) {
  std::vector<Point> points;
  for_each_piece(text, ' ', [&](std::string_view piece) { points.push_back(parse_point(piece)); });
  return points;
}

}  // namespace pathrace::results
