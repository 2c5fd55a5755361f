// The leaderboard for people: aligned columns, percentages, one block per family when grouped,
// and one more for runs through dynamic worlds.

#include <algorithm>

#include "results/leaderboard.hpp"
#include "results/leaderboard_columns.hpp"
#include "results/utf8.hpp"

namespace pathrace::results {
namespace {

using Line = std::vector<std::string>;

bool is_run(const Standing& standing) {
  return standing.track == Track::dynamic;
}

std::vector<LeaderboardColumn> shown_columns(bool runs) {
  using Block = LeaderboardColumn::Block;
  std::vector<LeaderboardColumn> shown;
  for (const LeaderboardColumn& column : leaderboard_columns()) {
    const bool here = column.block == Block::both || column.block == (runs ? Block::runs : Block::paths);
    if (here && !column.console_name.empty()) shown.push_back(column);
  }
  return shown;
}

/// Standings with the same columns, first to last.
std::vector<Line> lines_of(const std::vector<Standing>& standings,
                           const std::vector<LeaderboardColumn>& columns, bool runs) {
  std::vector<Line> lines(1);
  for (const LeaderboardColumn& column : columns) lines.front().emplace_back(column.console_name);
  for (const Standing& standing : standings) {
    if (is_run(standing) != runs) continue;
    lines.emplace_back();
    for (const LeaderboardColumn& column : columns) lines.back().push_back(column.console(standing));
  }
  return lines;
}

std::vector<std::size_t> widths_of(const std::vector<Line>& lines) {
  std::vector<std::size_t> widths(lines.front().size(), 0);
  for (const Line& line : lines) {
    for (std::size_t i = 0; i < line.size(); ++i) widths[i] = std::max(widths[i], letter_count(line[i]));
  }
  return widths;
}

std::string laid_out(const Line& line, const std::vector<LeaderboardColumn>& columns,
                     const std::vector<std::size_t>& widths) {
  std::string text;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const std::string blanks(widths[i] - letter_count(line[i]), ' ');
    text += (i == 0 ? "" : "  ") + (columns[i].left ? line[i] + blanks : blanks + line[i]);
  }
  text.erase(text.find_last_not_of(' ') + 1);
  return text;
}

}  // namespace

void print_console(std::ostream& out, const std::vector<Standing>& standings) {
  if (standings.empty()) {
    out << "no trials\n";
    return;
  }
  struct Table {
    std::vector<LeaderboardColumn> columns;
    std::vector<Line> lines;
    std::vector<std::size_t> widths;
    std::size_t next = 1;
  };
  Table tables[2];
  for (const bool runs : {false, true}) {
    Table& table = tables[runs ? 1 : 0];
    table.columns = shown_columns(runs);
    table.lines = lines_of(standings, table.columns, runs);
    table.widths = widths_of(table.lines);
  }
  bool crowded = false;
  for (std::size_t i = 0; i < standings.size(); ++i) {
    const Standing& standing = standings[i];
    Table& table = tables[is_run(standing) ? 1 : 0];
    const bool new_group = i == 0 || standing.group != standings[i - 1].group;
    const bool opens = new_group || is_run(standing) != is_run(standings[i - 1]);
    if (opens && i > 0) out << '\n';
    if (new_group && !standing.group.empty()) out << standing.group << '\n';
    if (opens) out << laid_out(table.lines.front(), table.columns, table.widths) << '\n';
    out << laid_out(table.lines[table.next++], table.columns, table.widths) << '\n';
    crowded = crowded || standing.crowded;
  }
  if (crowded) out << "~ trials ran side by side: compare their times with care\n";
}

}  // namespace pathrace::results
