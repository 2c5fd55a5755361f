// The record of a trial: what was asked, what came out, what it cost.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/catalogue.hpp"
#include "core/meter.hpp"
#include "core/metrics.hpp"
#include "core/path.hpp"
#include "core/run_metrics.hpp"

namespace pathrace {

enum class Verdict {
  solved,
  no_path,
  budget,
  gave_up,
  timeout,
  out_of_memory,
  crashed,
  exited,
  invalid,
  unsupported,
  bad_scenario
};

template <>
inline constexpr auto names_of<Verdict> = std::to_array<std::pair<Verdict, std::string_view>>({
    {Verdict::solved, "solved"},
    {Verdict::no_path, "no_path"},  // a proof only
    {Verdict::budget, "budget"},    // spent without an answer
    {Verdict::gave_up, "gave_up"},  // ended by itself, with neither an answer nor a proof
    {Verdict::timeout, "timeout"},  // killed
    {Verdict::out_of_memory, "out_of_memory"},
    {Verdict::crashed, "crashed"},  // an exception or a signal
    {Verdict::exited, "exited"},    // the planner ended the process
    {Verdict::invalid, "invalid"},  // the referee refused the answer, or it contradicts the proven optimum
    {Verdict::unsupported, "unsupported"},
    {Verdict::bad_scenario, "bad_scenario"},
});

/// True of verdicts that say that something is broken, not merely that there is no answer.
constexpr bool is_fault(Verdict verdict) {
  switch (verdict) {
    case Verdict::solved:
    case Verdict::no_path:
    case Verdict::budget:
    case Verdict::gave_up:
    case Verdict::unsupported: return false;
    case Verdict::timeout:
    case Verdict::out_of_memory:
    case Verdict::crashed:
    case Verdict::exited:
    case Verdict::invalid:
    case Verdict::bad_scenario: return true;
  }
  return true;
}

/// What names a trial. Backend, threads, jobs and wall-time limits are not in it.
struct TrialKey {
  std::string scenario;          ///< id
  std::uint64_t content = 0;     ///< the scenario's content hash
  std::string planner;           ///< full call, defaults included
  int version = 1;               ///< of the planner, Entrant::version
  std::uint64_t repetition = 0;  ///< counts from 0
  std::uint64_t seed = 0;        ///< of the campaign
  std::uint64_t budget = 0;      ///< work_hash of the budget

  std::uint64_t hash() const;
};

/// The stream that a trial starts from: campaign seed, scenario and repetition only, so that planners meet
/// the same draws and a variant with everything off equals its base.
Stream root_stream(std::uint64_t seed, std::string_view scenario, std::uint64_t repetition);

/// What may differ between two runs of the same trial.
struct Costs {
  double wall_s = 0;   ///< planning, set-up on the map included
  double setup_s = 0;  ///< set-up on the map alone
  std::string backend;
  int threads = 1;                       ///< asked for
  int threads_used = 1;                  ///< seen running
  bool crowded = false;                  ///< other trials ran at the same time
  std::optional<double> step_ms_median;  ///< of a navigator's steps
  std::optional<double> step_ms_p99;     ///< 99th percentile, the nearest rank
  std::optional<double> user_s;    ///< processor time of the threads that worked for the trial, where known
  std::optional<double> system_s;  ///< the part of it that the kernel spent for them
};

struct TrialRecord {
  std::uint64_t key = 0;
  Verdict verdict = Verdict::crashed;
  std::string note;  ///< why, where the verdict needs a reason
  Answer answer;
  std::optional<PathMetrics> metrics;  ///< of a solved trial on a static map
  std::optional<RunMetrics> run;  ///< of a run through a dynamic world that kept the rules, solved or not
  Work work;
  std::vector<TracePoint> trace;
  std::vector<Counter> counters;  ///< what the planner counted beside its work
  bool timed = false;             ///< cut short by the clock, or promises no repetition: outside digests
  Costs costs;
};

/// Hash of verdict, path, work and trace without its times. Neither key, counters nor costs are in it.
std::uint64_t digest(const TrialRecord& record);

/// One trial's part in a campaign's digest.
struct KeyedDigest {
  std::uint64_t key = 0;
  std::uint64_t digest = 0;
  bool timed = false;
};

/// Hash of the (key, digest) pairs sorted by key; timed rows are left out.
std::uint64_t campaign_digest(std::vector<KeyedDigest> rows);

}  // namespace pathrace
