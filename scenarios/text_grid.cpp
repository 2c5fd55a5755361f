#include "scenarios/text_grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "core/error.hpp"
#include "scenarios/file_bytes.hpp"
#include "scenarios/text.hpp"

namespace pathrace::scenarios {
namespace {

constexpr std::uintmax_t longest_text = std::uintmax_t{8} * OccupancyGrid::max_cells;  // bytes
constexpr std::string_view separators = ",; \t";

bool is_digit(char symbol) {
  return symbol == '0' || symbol == '1';
}

class Row {
 public:
  Row(std::string_view text, const std::string& name, int line) : text_(text), name_(name), line_(line) {}

  std::string cells() {
    skip_blanks();
    const std::string_view word = trimmed(text_);
    if (word.find_first_of(separators) == std::string_view::npos && !word.starts_with('"')) return run(word);
    std::string digits;
    while (at_ < text_.size()) {
      digits += cell();
      pass_separator();
    }
    return digits;
  }

 private:
  [[noreturn]] void fail(std::size_t at, std::string_view what) const {
    fail_at(name_, line_, fmt::format("{} in column {}; expected 0 or 1", what, at + 1));
  }

  void skip_blanks() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
  }

  // A row without separators: digits side by side, or one number as programs print it, 1.000e+00.
  std::string run(std::string_view word) const {
    const auto stranger = std::find_if_not(word.begin(), word.end(), is_digit);
    if (stranger == word.end()) return std::string(word);
    if (word.find_first_of(".eE") != std::string_view::npos && real_number(word))
      return {value_of(word, at_)};
    const auto at = static_cast<std::size_t>(stranger - word.begin());
    fail(at_ + at, fmt::format("'{}'", printable(word.substr(at, 1))));
  }

  char cell() {
    const std::size_t begin = at_;
    if (text_[at_] == '"') return value_of(trimmed(quoted()), begin);
    at_ = std::min(text_.find_first_of(separators, at_), text_.size());
    return value_of(text_.substr(begin, at_ - begin), begin);
  }

  std::string_view quoted() {
    const std::size_t begin = at_ + 1;
    const std::size_t end = text_.find('"', begin);
    if (end == std::string_view::npos) fail(at_, "a quote without its end");
    at_ = end + 1;
    if (at_ < text_.size() && separators.find(text_[at_]) == std::string_view::npos) {
      fail(at_, fmt::format("'{}' behind a quote", printable(text_.substr(at_, 1))));
    }
    return text_.substr(begin, end - begin);
  }

  char value_of(std::string_view word, std::size_t at) const {
    if (word == "0" || word == "1") return word.front();
    if (word.empty()) fail(at, "an empty cell");
    const std::string shown = fmt::format("'{}'", printable(word));
    if (std::all_of(word.begin(), word.end(), is_digit)) {
      fail_at(name_, line_,
              fmt::format("{} in column {}: cells with and without separators; expected one form", shown,
                          at + 1));
    }
    const std::optional<double> number = real_number(word);
    if (!number) fail(at, shown);
    if (*number == 0) return '0';
    if (*number == 1) return '1';
    fail_at(name_, line_,
            fmt::format("{} in column {}; expected 0, free, or 1, blocked: cells have no weights", shown,
                        at + 1));
  }

  // One comma or semicolon, or blanks alone; behind the last cell it ends the row.
  void pass_separator() {
    skip_blanks();
    if (at_ < text_.size() && (text_[at_] == ',' || text_[at_] == ';')) ++at_;
    skip_blanks();
  }

  std::string_view text_;
  const std::string& name_;
  int line_;
  std::size_t at_ = 0;
};

std::vector<std::string> read_rows(std::string_view text, const std::string& name) {
  Lines lines(text);
  std::vector<std::string> rows;
  while (const std::optional<std::string_view> line = lines.next()) {
    if (trimmed(*line).empty()) fail_at(name, lines.number(), "a blank line; expected a row of 0 and 1");
    rows.push_back(Row(*line, name, lines.number()).cells());
    const std::size_t width = rows.front().size();
    if (rows.back().size() != width) {
      fail_at(name, lines.number(),
              fmt::format("a row of {} cells; expected {}, as in line 1", rows.back().size(), width));
    }
    require_map_size(name, lines.number(), static_cast<std::int64_t>(width),
                     static_cast<std::int64_t>(rows.size()));
  }
  if (rows.empty()) fail_at(name, 1, "the file is empty; expected rows of 0 and 1");
  return rows;
}

}  // namespace

OccupancyGrid read_text_grid(const std::filesystem::path& file) {
  return parse_text_grid(whole_file(file, longest_text), file.string());
}

OccupancyGrid parse_text_grid(std::string_view text, const std::string& name) {
  const std::vector<std::string> rows = read_rows(text_of(text, name), name);
  OccupancyGrid grid(static_cast<int>(rows.front().size()), static_cast<int>(rows.size()));
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x) {
      if (rows[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)] == '1') grid.block({x, y});
    }
  }
  return grid;
}

void write_text_grid(std::ostream& out, const OccupancyGrid& grid, std::string_view separator) {
  for (int y = 0; y < grid.height(); ++y) {
    std::string row;
    for (int x = 0; x < grid.width(); ++x) {
      if (x > 0) row += separator;
      row += grid.is_free({x, y}) ? '0' : '1';
    }
    out << row << '\n';
  }
  if (!out) throw EnvironmentError("the grid could not be written");
}

}  // namespace pathrace::scenarios
