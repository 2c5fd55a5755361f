#include "results/row_writer.hpp"

#include <fmt/format.h>

#include <initializer_list>
#include <iterator>
#include <optional>
#include <string_view>

#include "core/hash.hpp"
#include "results/binder.hpp"
#include "results/counters_text.hpp"
#include "results/trace_text.hpp"

namespace pathrace::results {
namespace {

std::string identity_text(std::initializer_list<std::string_view> parts) {
  std::string text;
  for (const std::string_view part : parts)
    fmt::format_to(std::back_inserter(text), "{}:{}", part.size(), part);
  return text;
}

}  // namespace

Interner::Interner(SQLite::Database& database, const std::string& find, const std::string& insert)
    : database_(database), find_(database, find), insert_(database, insert) {}

std::int64_t Interner::number(const std::string& identity, const Bind& bind) {
  const auto known = known_.find(identity);
  if (known != known_.end()) return known->second;
  bind(find_);
  std::int64_t number = 0;
  if (find_.executeStep()) {
    number = find_.getColumn(0).getInt64();
  } else {
    bind(insert_);
    insert_.exec();
    number = database_.getLastInsertRowid();
  }
  find_.reset();
  known_.emplace(identity, number);
  return number;
}

ScenarioNumbers::ScenarioNumbers(SQLite::Database& database)
    : interner_(database, "SELECT number FROM scenario WHERE id = ? AND rule = ?",
                "INSERT INTO scenario (id, rule) VALUES (?, ?)") {}

std::int64_t ScenarioNumbers::number(const std::string& id, MoveRule rule) {
  return interner_.number(identity_text({id, name(rule)}),
                          [&](SQLite::Statement& statement) { Binder(statement).text(id).name(name(rule)); });
}

RowWriter::RowWriter(SQLite::Database& database)
    : database_(database),
      scenarios_(database),
      references_(database),
      planners_(database,
                "SELECT number FROM planner WHERE label = ? AND call = ? AND version = ? AND track = ? "
                "AND budget = ? AND draws IS ?",
                "INSERT INTO planner (label, call, version, track, budget, draws) VALUES (?, ?, ?, ?, ?, ?)"),
      insert_trial_(
          database,
          "INSERT INTO trial (key, scenario, planner, repetition, seed, verdict, note, length, gap, "
          "turns, turn_angle, clearance_min, clearance_mean, evaluations, iterations, checks, "
          "digest, timed, wall_s, setup_s, backend, threads, threads_used, crowded, steps, travelled, "
          "collisions, struck, min_clearance, oscillations, world_hash, least_steps, step_ms_median, "
          "step_ms_p99, user_s, system_s, session, checksum) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, "
          "?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)"),
      insert_answer_(database,
                     "INSERT INTO answer (trial, path_track, path, trace, counters, checksum) "
                     "VALUES (?, ?, ?, ?, ?, ?)") {}

void RowWriter::write(const TrialRow& row) {
  write_trial(row);
  write_answer(row);
}

void RowWriter::forget() {
  scenarios_.forget();
  references_.forget();
  planners_.forget();
}

std::int64_t RowWriter::planner_number(const TrialRow& row) {
  const std::string version = std::to_string(row.version);
  const std::string_view draws = !row.draws ? "" : *row.draws ? "1" : "0";
  return planners_.number(identity_text({row.planner, row.call, version, name(row.track), row.budget, draws}),
                          [&row](SQLite::Statement& statement) {
                            Binder(statement)
                                .text(row.planner)
                                .text(row.call)
                                .integer(std::int64_t{row.version})
                                .name(name(row.track))
                                .text(row.budget)
                                .flag(row.draws);
                          });
}

namespace {

void bind_run(Binder& binder, const std::optional<RunMetrics>& run) {
  if (!run) {
    for (int i = 0; i < 7; ++i) binder.null();
    return;
  }
  binder.count(run->steps)
      .real(run->travelled)
      .count(run->collisions)
      .count(run->struck)
      .real(run->min_clearance)
      .count(run->oscillations)
      .name(hex(run->world_hash));
}

}  // namespace

void RowWriter::write_trial(const TrialRow& row) {
  const std::int64_t scenario = scenarios_.number(row.scenario, row.rule);
  references_.put(scenario, row.scenario, row.track, row.optimum);
  Binder binder(insert_trial_);
  binder.name(hex(row.key))
      .integer(scenario)
      .integer(planner_number(row))
      .count(row.repetition)
      .count(row.seed)
      .name(name(row.verdict))
      .text(row.note)
      .real(row.length)
      .real(row.gap)
      .integer(row.turns)
      .real(row.turn_angle)
      .real(row.clearance_min)
      .real(row.clearance_mean)
      .count(row.work.evaluations)
      .count(row.work.iterations)
      .count(row.work.checks)
      .name(hex(row.digest))
      .integer(std::int64_t{row.timed})
      .real(row.costs.wall_s)
      .real(row.costs.setup_s)
      .text(row.costs.backend)
      .integer(std::int64_t{row.costs.threads})
      .integer(std::int64_t{row.costs.threads_used})
      .integer(std::int64_t{row.costs.crowded});
  bind_run(binder, row.run);
  binder.count(row.least_steps)
      .real(row.costs.step_ms_median)
      .real(row.costs.step_ms_p99)
      .real(row.costs.user_s)
      .real(row.costs.system_s)
      .integer(std::int64_t{row.session})
      .name(hex(checksum(row)));
  insert_trial_.exec();
}

void RowWriter::write_answer(const TrialRow& row) {
  const std::string path = row.answer ? print_points(*row.answer) : "";
  const std::string trace = print_trace(row.trace);
  const std::string counters = print_counters(row.counters);
  Binder binder(insert_answer_);
  binder.integer(database_.getLastInsertRowid());
  if (row.answer) {
    binder.name(name(row.answer->track)).text(path);
  } else {
    binder.null().null();
  }
  const auto in_answer = [&row](std::string_view text) {
    return row.answer ? std::optional(text) : std::nullopt;
  };
  binder.text(trace).text(counters).name(hex(
      checksum({in_answer(row.answer ? name(row.answer->track) : ""), in_answer(path), trace, counters})));
  insert_answer_.exec();
}

}  // namespace pathrace::results
