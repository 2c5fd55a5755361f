#include "results/trials_csv.hpp"

#include <fmt/format.h>

#include "core/hash.hpp"
#include "results/csv.hpp"
#include "results/number_text.hpp"

namespace pathrace::results {
namespace {

std::string print(const std::string& value) {
  return value;
}
std::string print(std::string_view value) {
  return std::string(value);
}
std::string print(double value) {
  return print_number(value);
}
std::string print(int value) {
  return std::to_string(value);
}
std::string print(std::uint64_t value) {
  return std::to_string(value);
}
std::string print(bool value) {
  return value ? "1" : "0";
}

template <typename T>
std::string print(const std::optional<T>& value) {
  return value ? print(*value) : "";
}

/// A figure of the run, or nothing.
template <typename T>
std::string run_figure(const TrialRow& row, T RunMetrics::*figure) {
  return row.run ? print((*row.run).*figure) : "";
}

struct Column {
  std::string name;
  std::string (*print)(const TrialRow&);
};

const std::vector<Column>& columns() {
  using Row = const TrialRow&;
  static const std::vector<Column> all = {
      {"key", [](Row row) { return hex(row.key); }},
      {"scenario", [](Row row) { return print(row.scenario); }},
      {"planner", [](Row row) { return print(row.planner); }},
      {"repetition", [](Row row) { return print(row.repetition); }},
      {"seed", [](Row row) { return print(row.seed); }},
      {"verdict", [](Row row) { return print(name(row.verdict)); }},
      {"track", [](Row row) { return print(name(row.track)); }},
      {"length", [](Row row) { return print(row.length); }},
      {"optimum", [](Row row) { return print(row.optimum); }},
      {"gap", [](Row row) { return print(row.gap); }},
      {"turns", [](Row row) { return print(row.turns); }},
      {"evaluations", [](Row row) { return print(row.work.evaluations); }},
      {"iterations", [](Row row) { return print(row.work.iterations); }},
      {"checks", [](Row row) { return print(row.work.checks); }},
      {"digest", [](Row row) { return hex(row.digest); }},
      {"wall_s", [](Row row) { return print(row.costs.wall_s); }},
      {"rule", [](Row row) { return print(name(row.rule)); }},
      {"call", [](Row row) { return print(row.call); }},
      {"version", [](Row row) { return print(row.version); }},
      {"budget", [](Row row) { return print(row.budget); }},
      {"note", [](Row row) { return print(row.note); }},
      {"turn_angle", [](Row row) { return print(row.turn_angle); }},
      {"clearance_min", [](Row row) { return print(row.clearance_min); }},
      {"clearance_mean", [](Row row) { return print(row.clearance_mean); }},
      {"timed", [](Row row) { return print(row.timed); }},
      {"setup_s", [](Row row) { return print(row.costs.setup_s); }},
      {"backend", [](Row row) { return print(row.costs.backend); }},
      {"threads", [](Row row) { return print(row.costs.threads); }},
      {"threads_used", [](Row row) { return print(row.costs.threads_used); }},
      {"crowded", [](Row row) { return print(row.costs.crowded); }},
      {"steps", [](Row row) { return run_figure(row, &RunMetrics::steps); }},
      {"travelled", [](Row row) { return run_figure(row, &RunMetrics::travelled); }},
      {"collisions", [](Row row) { return run_figure(row, &RunMetrics::collisions); }},
      {"struck", [](Row row) { return run_figure(row, &RunMetrics::struck); }},
      {"min_clearance", [](Row row) { return run_figure(row, &RunMetrics::min_clearance); }},
      {"oscillations", [](Row row) { return run_figure(row, &RunMetrics::oscillations); }},
      {"world_hash", [](Row row) { return row.run ? hex(row.run->world_hash) : ""; }},
      {"least_steps", [](Row row) { return print(row.least_steps); }},
      {"step_ms_median", [](Row row) { return print(row.costs.step_ms_median); }},
      {"step_ms_p99", [](Row row) { return print(row.costs.step_ms_p99); }},
      {"user_s", [](Row row) { return print(row.costs.user_s); }},
      {"system_s", [](Row row) { return print(row.costs.system_s); }},
      {"session", [](Row row) { return print(row.session); }},
      {"draws", [](Row row) { return print(row.draws); }},
  };
  return all;
}

}  // namespace

void write_trials_csv(std::ostream& out, const Store& store) {
  std::vector<std::string> fields;
  for (const Column& column : columns()) fields.push_back(column.name);
  write_csv_line(out, fields);
  store.for_each_slim([&](const TrialRow& row) {
    for (std::size_t i = 0; i < fields.size(); ++i) fields[i] = columns()[i].print(row);
    write_csv_line(out, fields);
  });
}

}  // namespace pathrace::results
