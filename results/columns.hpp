// Values out of a statement, trusting nothing: the file may have been edited or damaged.
#pragma once

#include <SQLiteCpp/Column.h>
#include <SQLiteCpp/Statement.h>
#include <fmt/format.h>

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include "core/error.hpp"
#include "core/names.hpp"
#include "results/number_text.hpp"
#include "results/quote.hpp"

namespace pathrace::results {

inline std::string_view text_of(const SQLite::Column& column) {
  const char* text = column.getText();
  return {text, static_cast<std::size_t>(column.getBytes())};
}

template <typename Parse>
auto parsed_text(const SQLite::Column& column, const Parse& parse) {
  try {
    return parse(text_of(column));
  } catch (const InputError& error) {
    throw InputError(fmt::format("column '{}': {}", column.getName(), error.what()));
  }
}

/// The columns of the current row from left to right, each with the type that it must have. Throws InputError
/// that names the column.
class Columns {
 public:
  explicit Columns(SQLite::Statement& statement) : statement_(statement) {}

  std::string_view text() {
    const SQLite::Column column = next();
    if (!column.isText()) fail(column, "text");
    return text_of(column);
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
  std::optional<std::uint64_t> optional_count() {
    return optional([this] { return count(); });
  }
  bool flag() {
    const SQLite::Column column = next();
    if (!column.isInteger() || (column.getInt64() != 0 && column.getInt64() != 1)) fail(column, "0 or 1");
    return column.getInt64() == 1;
  }
  std::optional<bool> optional_flag() {
    return optional([this] { return flag(); });
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
    const std::string found = column.isNull() ? "nothing" : results::quoted(column.getString());
    throw InputError(fmt::format("column '{}': expected {}, got {}", column.getName(), expected, found));
  }

  SQLite::Statement& statement_;
  int index_ = 0;
};

}  // namespace pathrace::results
