// A row: one trial as it is stored and printed, flat and free of the library's other types.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/catalogue.hpp"
#include "core/record.hpp"
#include "core/scenario.hpp"

namespace pathrace::results {

struct TrialRow {
  std::uint64_t key = 0;
  std::string scenario;  ///< id
  std::string planner;   ///< label
  std::string call;      ///< the planner with every parameter
  int version = 1;       ///< of the planner's card
  std::uint64_t repetition = 0;
  std::uint64_t seed = 0;
  std::string budget;  ///< as printed by to_string(Budget)
  Verdict verdict = Verdict::crashed;
  std::string note;  ///< why, where the verdict needs a reason
  Track track = Track::lattice;
  MoveRule rule = MoveRule::strict;
  std::optional<double>
      length;  ///< cells; of solved trials, like the other metrics; way travelled in a world
  std::optional<double> optimum;  ///< cells, of the track; empty where none is proven or there is no way
  std::optional<double> gap;      ///< length / optimum - 1; in a dynamic world, steps / least_steps - 1
  std::optional<int> turns;
  std::optional<double> turn_angle;          ///< radians
  std::optional<double> clearance_min;       ///< cells
  std::optional<double> clearance_mean;      ///< cells
  std::optional<RunMetrics> run;             ///< in a dynamic world, of every run that kept the rules
  std::optional<std::uint64_t> least_steps;  ///< in a dynamic world: steps of the informed pursuit
  Work work;                                 ///< evaluations, iterations, checks
  std::uint64_t digest = 0;
  bool timed = false;  ///< cut short by a wall-time limit, or promises no repetition
  Costs costs;
  int session = 0;            ///< whose machine it ran on: Store::begin_session; 0: unknown
  bool altered = false;       ///< as read from a store: changed after it was recorded
  std::optional<bool> draws;  ///< whether the planner draws random numbers; empty: unknown
  Answer answer;              ///< the path itself
  std::vector<TracePoint> trace;
  std::vector<Counter> counters;
};

TrialRow make_row(const TrialKey& key, const Scenario& scenario, const Entrant& entrant, const Budget& budget,
                  const TrialRecord& record);

/// The digest that the row's own verdict, path, work and trace add up to; differs from `row.digest` when a
/// stored row was altered.
std::uint64_t recomputed_digest(const TrialRow& row);

/// Hash of everything that a slim row holds, costs included: tells whether a stored row was changed.
std::uint64_t checksum(const TrialRow& row);
/// The same of columns of text, null for none.
std::uint64_t checksum(const std::vector<std::optional<std::string_view>>& texts);

/// The path as text, "0,0 1,1 2,1", in the shortest decimals that read back as the same numbers.
std::string print_points(const Path& path);
/// The reverse. Throws InputError on anything else.
std::vector<Point> parse_points(std::string_view text);

}  // namespace pathrace::results
