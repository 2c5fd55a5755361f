#include "results/row_reader.hpp"

#include "core/error.hpp"
#include "core/hash.hpp"
#include "results/columns.hpp"
#include "results/counters_text.hpp"
#include "results/number_text.hpp"
#include "results/trace_text.hpp"

namespace pathrace::results {
namespace {

// All of them or none.
void read_run_columns(Columns& columns, TrialRow& row) {
  row.run.reset();
  if (columns.null()) {
    for (int i = 0; i < 7; ++i) {
      if (!columns.null()) throw InputError("column 'steps': expected a count beside a run's other figures");
      columns.skip();
    }
    return;
  }
  RunMetrics& run = row.run.emplace();
  run.steps = columns.count();
  run.travelled = columns.real();
  run.collisions = columns.count();
  run.struck = columns.count();
  run.min_clearance = columns.optional_real();
  run.oscillations = columns.count();
  run.world_hash = columns.parsed(parse_hex);
}

void read_slim_columns(Columns& columns, TrialRow& row) {
  row.key = columns.parsed(parse_hex);
  row.scenario = columns.text();
  row.planner = columns.text();
  row.repetition = columns.count();
  row.seed = columns.count();
  row.verdict = columns.named<Verdict>();
  row.track = columns.named<Track>();
  row.length = columns.optional_real();
  row.optimum = columns.optional_real();
  row.gap = columns.optional_real();
  row.turns = columns.optional_integer();
  row.work.evaluations = columns.count();
  row.work.iterations = columns.count();
  row.work.checks = columns.count();
  row.digest = columns.parsed(parse_hex);
  row.costs.wall_s = columns.real();
  row.rule = columns.named<MoveRule>();
  row.call = columns.text();
  row.version = columns.integer();
  row.budget = columns.text();
  row.note = columns.text();
  row.turn_angle = columns.optional_real();
  row.clearance_min = columns.optional_real();
  row.clearance_mean = columns.optional_real();
  row.timed = columns.flag();
  row.costs.setup_s = columns.real();
  row.costs.backend = columns.text();
  row.costs.threads = columns.integer();
  row.costs.threads_used = columns.integer();
  row.costs.crowded = columns.flag();
  read_run_columns(columns, row);
  row.least_steps = columns.optional_count();
  row.costs.step_ms_median = columns.optional_real();
  row.costs.step_ms_p99 = columns.optional_real();
  row.costs.user_s = columns.optional_real();
  row.costs.system_s = columns.optional_real();
  row.session = columns.integer();
  row.draws = columns.optional_flag();
}

// A store of version 5 has none.
bool matches(Columns& columns, std::uint64_t due) {
  if (!columns.null()) return columns.parsed(parse_hex) == due;
  columns.skip();
  return true;
}

constexpr int answer_columns = 4;  // path_track, path, trace, counters; their checksum is the last of all

void read_answer_columns(Columns& columns, TrialRow& row) {
  row.answer.reset();
  if (columns.null()) {
    columns.skip();
    if (!columns.null()) throw InputError("column 'path_track': expected the track of the path, got nothing");
    columns.skip();
  } else {
    row.answer.emplace();
    row.answer->track = columns.named<Track>();
    row.answer->points = columns.parsed(parse_points);
  }
  row.trace = columns.parsed(parse_trace);
  row.counters = columns.parsed(parse_counters);
}

}  // namespace

void read_slim(SQLite::Statement& statement, TrialRow& row) {
  Columns columns(statement);
  read_slim_columns(columns, row);
  row.altered = !matches(columns, checksum(row));
}

void read_full(SQLite::Statement& statement, TrialRow& row) {
  Columns columns(statement);
  read_slim_columns(columns, row);
  row.altered = !matches(columns, checksum(row));
  read_answer_columns(columns, row);
  if (!matches(columns, answer_checksum(statement))) row.altered = true;
}

std::uint64_t answer_checksum(SQLite::Statement& statement) {
  std::vector<std::optional<std::string_view>> texts;
  for (int i = statement.getColumnCount() - 1 - answer_columns; i < statement.getColumnCount() - 1; ++i) {
    const SQLite::Column column = statement.getColumn(i);
    texts.push_back(column.isNull() ? std::nullopt : std::optional(text_of(column)));
  }
  return checksum(texts);
}

OutcomeCount read_outcome(SQLite::Statement& statement) {
  Columns columns(statement);
  OutcomeCount outcome;
  outcome.planner = columns.text();
  outcome.verdict = columns.named<Verdict>();
  outcome.noted = columns.flag();
  outcome.trials = columns.count();
  return outcome;
}

void read_scenario(SQLite::Statement& statement, ScenarioRow& row) {
  Columns columns(statement);
  row.id = columns.text();
  row.rule = columns.named<MoveRule>();
  row.optimum = columns.optional_real();
  row.any_angle_optimum = columns.optional_real();
  row.width = columns.integer();
  row.height = columns.integer();
  row.start.x = columns.integer();
  row.start.y = columns.integer();
  row.goal.x = columns.integer();
  row.goal.y = columns.integer();
  row.hash = columns.parsed(parse_hex);
  row.features.clear();
  if (columns.null()) return;
  row.features.emplace_back();
  row.features.back().name = columns.text();
  row.features.back().value = columns.optional_real();
}

}  // namespace pathrace::results
