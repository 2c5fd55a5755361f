#include "results/row_reader.hpp"

#include <SQLiteCpp/Column.h>
#include <fmt/format.h>

#include <limits>
#include <optional>
#include <string_view>

#include "core/error.hpp"
#include "results/number_text.hpp"
#include "results/quote.hpp"
#include "results/trace_text.hpp"

namespace pathrace::results {
namespace {

std::string_view view(const SQLite::Column& column) {
  const char* text = column.getText();
  return {text, static_cast<std::size_t>(column.getBytes())};
}

template <typename Parse>
auto parsed_text(const SQLite::Column& column, const Parse& parse) {
  try {
    return parse(view(column));
  } catch (const InputError& error) {
    throw InputError(fmt::format("column '{}': {}", column.getName(), error.what()));
  }
}

// The columns of the current row from left to right, each with the type that it must have.
class Columns {
 public:
  explicit Columns(SQLite::Statement& statement) : statement_(statement) {}

  std::string_view text() {
    const SQLite::Column column = next();
    if (!column.isText()) fail(column, "text");
    return view(column);
  }
  bool null() const { return statement_.isColumnNull(index_); }
  void skip() { ++index_; }

  double real() {
    const SQLite::Column column = next();
    if (!column.isFloat() && !column.isInteger()) fail(column, "a number");
    return column.getDouble();
  }
  std::optional<double> optional_real() {
    return optional([this] { return real(); });
  }

  int integer() {
    const SQLite::Column column = next();
    const std::int64_t value = column.isInteger() ? column.getInt64() : std::int64_t{-1};
    if (value < 0 || value > std::numeric_limits<int>::max()) fail(column, "a small non-negative integer");
    return static_cast<int>(value);
  }
  std::optional<int> optional_integer() {
    return optional([this] { return integer(); });
  }

  std::uint64_t count() {
    const SQLite::Column column = next();
    if (column.isText()) return parsed_text(column, parse_count);
    if (!column.isInteger() || column.getInt64() < 0) fail(column, "a count");
    return static_cast<std::uint64_t>(column.getInt64());
  }
  bool flag() {
    const SQLite::Column column = next();
    if (!column.isInteger() || (column.getInt64() != 0 && column.getInt64() != 1)) fail(column, "0 or 1");
    return column.getInt64() == 1;
  }

  /// Text that `parse` understands; its complaint comes out with the column's name.
  template <typename Parse>
  auto parsed(const Parse& parse) {
    const SQLite::Column column = next();
    if (!column.isText()) fail(column, "text");
    return parsed_text(column, parse);
  }
  template <typename Enum>
  Enum named() {
    return parsed([](std::string_view text) { return parse_name<Enum>("value", text); });
  }

 private:
  SQLite::Column next() { return statement_.getColumn(index_++); }

  template <typename Read>
  auto optional(const Read& read) -> std::optional<decltype(read())> {
    if (!null()) return read();
    skip();
    return std::nullopt;
  }

  [[noreturn]] static void fail(const SQLite::Column& column, std::string_view expected) {
    const std::string found = column.isNull() ? "nothing" : quoted(column.getString());
    throw InputError(fmt::format("column '{}': expected {}, got {}", column.getName(), expected, found));
  }

  SQLite::Statement& statement_;
  int index_ = 0;
};

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
}

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
}

}  // namespace

void read_slim(SQLite::Statement& statement, TrialRow& row) {
  Columns columns(statement);
  read_slim_columns(columns, row);
}

void read_full(SQLite::Statement& statement, TrialRow& row) {
  Columns columns(statement);
  read_slim_columns(columns, row);
  read_answer_columns(columns, row);
}

void read_digest(SQLite::Statement& statement, TrialRow& row) {
  Columns columns(statement);
  row.key = columns.parsed(parse_hex);
  row.digest = columns.parsed(parse_hex);
  row.timed = columns.flag();
}

}  // namespace pathrace::results
