// The leaderboard: one standing per planner and track, over all trials or within each scenario family.
//
// Gaps count from the proven optimum of the planner's own track: on the lattice, or at any angle.
// A failed trial counts as an infinitely long path where that optimum is known, so a planner
// cannot improve its gap by giving up on hard scenarios; `gap_solved` stands beside it. Ranked by success,
// then gap, then gap of the solved trials; standings equal in all three share a rank (1, 1, 3).
//
// Runs through dynamic worlds are ranked apart, after all paths on maps: nobody races on both. Their gap
// counts steps against the informed pursuit's.
//
// To add a column: a member of Standing, a line in `standing_of` (leaderboard.cpp), and an entry in
// leaderboard_columns.cpp, from which every renderer reads.
#pragma once

#include <cstdint>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "core/path.hpp"
#include "results/store.hpp"

namespace pathrace::results {

struct Standing {
  int rank = 0;         ///< from 1, within its group; runs in dynamic worlds have a ranking of their own
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
  bool crowded = false;                      ///< some of the times come from trials that ran beside others
};

enum class Grouping { all, family };

/// The scenario's id up to its first slash.
std::string family_of(const std::string& scenario);

/// Sorted by group, then paths before runs, then rank, then label. Reads the store once, without paths.
std::vector<Standing> leaderboard(const Store& store, Grouping grouping);

/// `rank,planner,track,...`; `-` where there is no value; `family` comes last when standings are grouped.
void write_csv(std::ostream& out, const std::vector<Standing>& standings);

/// Aligned columns for people.
void print_console(std::ostream& out, const std::vector<Standing>& standings);

}  // namespace pathrace::results
