// The leaderboard: one standing per planner and track, over all trials or within each scenario family.
//
// Each track has a ranking of its own. Gaps count from the proven optimum of the track; in dynamic worlds,
// steps against the informed pursuit's. A failed trial counts as an infinitely long path where that optimum
// is known, so a planner cannot improve its gap by giving up on hard scenarios; `gap_solved` stands beside
// it. A planner that draws no random numbers counts once per scenario, by its first repetition. Standings
// equal in success and both gaps share a rank (1, 1, 3).
//
// To add a column: a member of Standing, a line in `standing_of` (leaderboard.cpp), and an entry in
// leaderboard_columns.cpp, from which every renderer reads.
#pragma once

#include <cstdint>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "core/path.hpp"
#include "results/store.hpp"

namespace pathrace::results {

struct Standing {
  int rank = 0;         ///< from 1, within its group and track
  std::string group;    ///< the family when grouped, else empty
  std::string planner;  ///< label
  Track track = Track::lattice;
  std::uint64_t trials = 0;
  std::uint64_t solved = 0;
  double success = 0;                        ///< solved / trials
  std::optional<double> gap_median;          ///< over trials with a reference; empty when infinite or none
  std::optional<double> gap_solved;          ///< the same over solved trials
  std::optional<double> length_median;       ///< cells, over solved trials
  std::optional<double> turns_median;        ///< over solved trials
  std::optional<double> evaluations_median;  ///< over all trials, like the next two
  std::optional<double> checks_median;
  std::optional<double> time_ms_median;
  // In dynamic worlds; empty elsewhere.
  std::optional<double> steps_median;          ///< over solved trials, like the next two
  std::optional<double> min_clearance_median;  ///< units
  std::optional<double> oscillations_median;
  std::optional<double> collisions_mean;  ///< over all runs that kept the rules, like the next one
  std::optional<double> struck_mean;
  std::optional<double> step_ms_median;      ///< median over runs of the median step
  std::optional<double> step_ms_p99_median;  ///< median over runs of the 99th percentile
  std::uint64_t gave_up = 0;                 ///< trials with this verdict, like the next two
  std::uint64_t crashed = 0;
  std::uint64_t invalid = 0;
  bool crowded = false;  ///< some of the times come from trials that ran beside others
};

enum class Grouping { all, family };

/// How standings are ranked, for people.
inline constexpr const char* ranking_rule =
    "Ranked on each track by success, then gap (a failed trial's is infinite), then gap of the solved "
    "trials.";

/// The scenario's id without what numbers its questions: `discs/ring` of `discs/ring/3`, `dense/20-30` of
/// `dense/20-30/7`, `asr` of `asr/fig5`, `map/office` of `map/office/1,2/30,4` with its start and goal.
std::string family_of(std::string_view scenario);

/// Sorted by group, then track, then rank, then label. Reads the store once, without paths.
std::vector<Standing> leaderboard(const Store& store, Grouping grouping);

/// `rank,planner,track,...`; empty where there is no value; `family` comes last when standings are grouped.
void write_csv(std::ostream& out, const std::vector<Standing>& standings);

inline constexpr std::size_t console_width = 120;  ///< letters

/// A table per group and track in aligned columns. Lines longer than `width` letters lose the least important
/// columns first; then long labels lose their middle. 0: whatever the width.
void print_console(std::ostream& out, const std::vector<Standing>& standings,
                   std::size_t width = console_width);

}  // namespace pathrace::results
