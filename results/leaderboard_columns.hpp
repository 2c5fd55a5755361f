// The columns of the leaderboard: how each is called and printed, once for all renderers.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "results/leaderboard.hpp"

namespace pathrace::results {

struct LeaderboardColumn {
  using Print = std::string (*)(const Standing&);

  std::string_view csv_name;
  Print csv;
  std::string_view console_name;  ///< empty: the console leaves the column out
  Print console;
  bool left = false;  ///< aligned on the console
  /// Which blocks of the console show it: those of paths on maps, of runs through dynamic worlds, or both.
  enum class Block { both, paths, runs } block = Block::both;
};

/// In the order of the CSV file, `family` excepted.
const std::vector<LeaderboardColumn>& leaderboard_columns();

}  // namespace pathrace::results
