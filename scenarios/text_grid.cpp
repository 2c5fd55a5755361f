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

constexpr std::uintmax_t longest_text = std::uintmax_t{128} << 20;  // eight bytes for each of the most cells

class Row {
 public:
  Row(std::string_view text, const std::string& name, int line) : text_(text), name_(name), line_(line) {}

  std::string cells() {
    std::string digits;
    skip_blanks();
    while (true) {
      digits += digit();
      if (!separator()) return digits;
    }
  }

 private:
  bool at_end() const { return at_ == text_.size(); }

  void skip_blanks() {
    while (!at_end() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
  }

  char digit() {
    if (at_end()) fail_at(name_, line_, fmt::format("the row ends at column {}; expected 0 or 1", at_ + 1));
    const char symbol = text_[at_];
    if (symbol != '0' && symbol != '1') {
      fail_at(name_, line_,
              fmt::format("'{}' in column {}; expected 0 or 1", printable(text_.substr(at_, 1)), at_ + 1));
    }
    ++at_;
    return symbol;
  }

  // Passes what stands between two cells; false at the end of the row.
  bool separator() {
    const std::size_t begin = at_;
    skip_blanks();
    if (at_end()) return false;
    if (text_[at_] == ',' || text_[at_] == ';') {
      ++at_;
      skip_blanks();
    }
    const bool found = at_ > begin;
    if (separated_ && *separated_ != found) {
      fail_at(name_, line_,
              fmt::format("column {}: cells with and without separators; expected one form", begin + 1));
    }
    separated_ = found;
    return true;
  }

  std::string_view text_;
  const std::string& name_;
  int line_;
  std::size_t at_ = 0;
  std::optional<bool> separated_;
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
  constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";  // as spreadsheets write it
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  const std::vector<std::string> rows = read_rows(text, name);
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
