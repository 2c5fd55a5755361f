// The leaderboard for people: aligned columns, percentages, one block per family when grouped.

#include <algorithm>

#include "results/leaderboard.hpp"
#include "results/leaderboard_columns.hpp"
#include "results/utf8.hpp"

namespace pathrace::results {
namespace {

using Line = std::vector<std::string>;

std::vector<LeaderboardColumn> shown_columns() {
  std::vector<LeaderboardColumn> shown;
  for (const LeaderboardColumn& column : leaderboard_columns()) {
    if (!column.console_name.empty()) shown.push_back(column);
  }
  return shown;
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
  const std::vector<LeaderboardColumn> columns = shown_columns();
  std::vector<Line> lines(1);
  for (const LeaderboardColumn& column : columns) lines.front().emplace_back(column.console_name);
  for (const Standing& standing : standings) {
    lines.emplace_back();
    for (const LeaderboardColumn& column : columns) lines.back().push_back(column.console(standing));
  }
  const std::vector<std::size_t> widths = widths_of(lines);
  bool crowded = false;
  for (std::size_t i = 0; i < standings.size(); ++i) {
    const std::string& group = standings[i].group;
    const bool opens = i == 0 || group != standings[i - 1].group;
    if (opens && !group.empty()) out << (i == 0 ? "" : "\n") << group << '\n';
    if (opens) out << laid_out(lines.front(), columns, widths) << '\n';
    out << laid_out(lines[i + 1], columns, widths) << '\n';
    crowded = crowded || standings[i].crowded;
  }
  if (crowded) out << "~ trials ran side by side: compare their times with care\n";
}

}  // namespace pathrace::results
