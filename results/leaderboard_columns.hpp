// The columns of the leaderboard: how each is called and printed, once for all renderers.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "results/leaderboard.hpp"

namespace pathrace::results {

struct LeaderboardColumn {
  using Print = std::string (*)(const Standing&);

  /// Which tables of the console show it: of paths on maps, of runs through dynamic worlds, or both; or only
  /// those in which it is not 0 everywhere.
  enum class Table { both, paths, runs, where_not_zero };

  std::string_view csv_name;
  Print csv;
  std::string_view console_name;  ///< empty: the console leaves the column out
  Print console;
  int spare = 0;  ///< where lines are too long, the column with the greatest goes first; 0: never
  Table table = Table::both;
  bool label = false;  ///< aligned on the left, and shortened in lines that are still too long
};

/// In the order of the CSV file, `family` excepted.
const std::vector<LeaderboardColumn>& leaderboard_columns();

}  // namespace pathrace::results
