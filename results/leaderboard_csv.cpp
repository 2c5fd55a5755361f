#include "results/csv.hpp"
#include "results/leaderboard.hpp"
#include "results/leaderboard_columns.hpp"

namespace pathrace::results {

void write_csv(std::ostream& out, const std::vector<Standing>& standings) {
  const bool grouped = !standings.empty() && !standings.front().group.empty();
  std::vector<std::string> names;
  for (const LeaderboardColumn& column : leaderboard_columns()) names.emplace_back(column.csv_name);
  if (grouped) names.emplace_back("family");
  write_csv_line(out, names);
  for (const Standing& standing : standings) {
    std::vector<std::string> fields;
    for (const LeaderboardColumn& column : leaderboard_columns()) fields.push_back(column.csv(standing));
    if (grouped) fields.push_back(standing.group);
    write_csv_line(out, fields);
  }
}

}  // namespace pathrace::results
