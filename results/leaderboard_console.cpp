// The leaderboard for people: a headline and a table per group and track, in aligned columns that fit the
// console.
#include <algorithm>
#include <span>

#include "core/plain_text.hpp"
#include "core/utf8.hpp"
#include "results/leaderboard.hpp"
#include "results/leaderboard_columns.hpp"

namespace pathrace::results {
namespace {

using Block = std::span<const Standing>;

constexpr std::size_t gutter = 2;          // letters between two columns
constexpr std::size_t roomy_label = 36;    // columns go before labels become shorter,
constexpr std::size_t shortest_label = 8;  // and this is how far those may shrink

struct Column {
  const LeaderboardColumn* card;
  std::vector<std::string> cells;  // the name first
  std::size_t width = 0;
};

bool belongs(const LeaderboardColumn& column, Block block) {
  using Table = LeaderboardColumn::Table;
  const bool runs = block.front().track == Track::dynamic;
  switch (column.table) {
    case Table::both: return !column.console_name.empty();
    case Table::paths: return !runs;
    case Table::runs: return runs;
    case Table::where_not_zero:
      return std::any_of(block.begin(), block.end(), [&](const Standing& s) { return column.csv(s) != "0"; });
  }
  return false;
}

void measure(Column& column) {
  column.width = 0;
  for (const std::string& cell : column.cells) column.width = std::max(column.width, letter_count(cell));
}

std::vector<Column> columns_of(Block block) {
  std::vector<Column> columns;
  for (const LeaderboardColumn& card : leaderboard_columns()) {
    if (!belongs(card, block)) continue;
    Column& column = columns.emplace_back(Column{&card, {std::string(card.console_name)}});
    for (const Standing& standing : block) column.cells.push_back(escape_controls(card.console(standing)));
    measure(column);
  }
  return columns;
}

// Of a line, with labels of at most `label` letters.
std::size_t width_of(const std::vector<Column>& columns, std::size_t label) {
  std::size_t width = gutter * (columns.size() - 1);
  for (const Column& column : columns) {
    width += column.card->label ? std::min(column.width, label) : column.width;
  }
  return width;
}

void fit(std::vector<Column>& columns, std::size_t width) {
  while (width_of(columns, roomy_label) > width) {
    const auto sparest =
        std::max_element(columns.begin(), columns.end(),
                         [](const Column& a, const Column& b) { return a.card->spare < b.card->spare; });
    if (sparest->card->spare == 0) break;
    columns.erase(sparest);
  }
  const std::size_t others = width_of(columns, 0);
  for (Column& column : columns) {
    if (!column.card->label) continue;
    for (std::string& cell : column.cells) {
      cell = shortened(cell, std::max(shortest_label, width - std::min(width, others)));
    }
    measure(column);
  }
}

std::string line_of(const std::vector<Column>& columns, std::size_t row) {
  std::string text;
  for (const Column& column : columns) {
    const std::string& cell = column.cells[row];
    const std::string blanks(column.width - letter_count(cell), ' ');
    if (!text.empty()) text.append(gutter, ' ');
    text += column.card->label ? cell + blanks : blanks + cell;
  }
  text.erase(text.find_last_not_of(' ') + 1);
  return text;
}

std::string headline_of(const Standing& standing) {
  const std::string group = standing.group.empty() ? "" : escape_controls(standing.group) + ", ";
  switch (standing.track) {
    case Track::lattice: return group + "lattice: from cell to cell";
    case Track::any_angle: return group + "any_angle: straight through free space";
    case Track::dynamic: return group + "dynamic: among moving discs";
  }
  return group;
}

void print_table(std::ostream& out, Block block, std::size_t width) {
  std::vector<Column> columns = columns_of(block);
  if (width > 0) fit(columns, width);
  out << headline_of(block.front()) << '\n';
  for (std::size_t row = 0; row <= block.size(); ++row) out << line_of(columns, row) << '\n';
  out << '\n';
}

}  // namespace

void print_console(std::ostream& out, const std::vector<Standing>& standings, std::size_t width) {
  if (standings.empty()) {
    out << "no trials\n";
    return;
  }
  const auto crowded = [](const Standing& standing) { return standing.crowded; };
  for (auto begin = standings.begin(); begin != standings.end();) {
    const auto end = std::find_if(begin, standings.end(), [&](const Standing& standing) {
      return standing.group != begin->group || standing.track != begin->track;
    });
    print_table(out, Block(begin, end), width);
    begin = end;
  }
  out << ranking_rule << '\n';
  if (std::any_of(standings.begin(), standings.end(), crowded)) {
    out << "~ trials ran side by side: compare their times with care\n";
  }
}

}  // namespace pathrace::results
