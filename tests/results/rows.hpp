// Rows for the tests of the results room, and a folder of their own for their files.
#pragma once

#include <gtest/gtest.h>
#include <stdlib.h>

#include <bit>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "core/hash.hpp"
#include "results/store.hpp"

namespace pathrace::results {

/// A new folder that goes away with the object.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "pathrace-results-XXXXXX").string();
    if (::mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder: " + pattern);
    path_ = pattern;
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

inline StoreIdentity some_identity() {
  return {"a campaign", "[campaign]\nname = \"a campaign\"\n", 0xFEDCBA9876543210U, 18446744073709551615U,
          12};
}

/// A solved trial of a path of two steps on a map whose optimum is 2.
inline TrialRow solved_row(std::uint64_t key, const std::string& planner, const std::string& scenario) {
  TrialRow row;
  row.key = key;
  row.scenario = scenario;
  row.planner = planner;
  row.call = planner + ":a=1,b=2";
  row.budget = "evaluations=100";
  row.verdict = Verdict::solved;
  row.length = 2;
  row.optimum = 2;
  row.gap = 0;
  row.turns = 0;
  row.turn_angle = 0;
  row.clearance_min = 1;
  row.clearance_mean = 1;
  row.work = {1, 1, 3};
  row.costs = {0.001, 0.0005, "serial", 1, 1, false, {}, {}, {}, {}};
  row.answer = lattice_path({{0, 0}, {1, 0}, {2, 0}});
  row.trace = {{{1, 0, 3}, 0.0007, 2}};
  row.digest = recomputed_digest(row);
  return row;
}

/// A trial without an answer on the same map.
inline TrialRow failed_row(std::uint64_t key, const std::string& planner, const std::string& scenario) {
  TrialRow row = solved_row(key, planner, scenario);
  row.verdict = Verdict::budget;
  row.length = row.gap = row.turn_angle = row.clearance_min = row.clearance_mean = std::nullopt;
  row.turns = std::nullopt;
  row.answer = std::nullopt;
  row.trace.clear();
  row.digest = recomputed_digest(row);
  return row;
}

/// A run of 30 steps through a dynamic world in which 20 are the least.
inline TrialRow run_row(std::uint64_t key, const std::string& planner, const std::string& scenario) {
  TrialRow row = solved_row(key, planner, scenario);
  row.track = Track::dynamic;
  row.optimum = row.turn_angle = row.clearance_min = row.clearance_mean = std::nullopt;
  row.turns = std::nullopt;
  row.run = RunMetrics{30, 88.5, 0, 1, 2, 0.25, 0xFEDCBA9876543210U};
  row.least_steps = 20;
  row.length = 88.5;
  row.gap = 0.5;
  row.costs.step_ms_median = 0.125;
  row.costs.step_ms_p99 = 0.5;
  row.answer = Path{Track::dynamic, {{0.5, 0}, {1, 0.25}}};
  row.digest = recomputed_digest(row);
  return row;
}

/// Values at the edges of what columns can hold.
inline std::vector<TrialRow> strange_rows() {
  using Limits = std::numeric_limits<double>;
  std::vector<TrialRow> rows = {solved_row(0, "plain", "trap-u/20/1"), failed_row(1, "plain", "trap-u/20/1")};

  TrialRow numbers = solved_row(std::numeric_limits<std::uint64_t>::max(), "numbers", "dense/10-20/1");
  numbers.length = 0.1 + 0.2;
  numbers.optimum = Limits::denorm_min();
  numbers.gap = -0.0;
  numbers.turn_angle = Limits::max();
  numbers.clearance_min = 1.0 / 3;
  numbers.clearance_mean = 9007199254740993.0;
  numbers.seed = std::numeric_limits<std::uint64_t>::max();
  numbers.repetition = std::uint64_t{1} << 63;
  numbers.work = {std::numeric_limits<std::uint64_t>::max(), (std::uint64_t{1} << 63) - 1, 0};
  numbers.costs = {Limits::min(), 1e-300, "openmp", 64, 7, true, {}, {}, 0.1 + 0.7, Limits::denorm_min()};
  numbers.session = std::numeric_limits<int>::max();
  numbers.draws = true;
  numbers.answer = Path{Track::any_angle,
                        {{-0.0, 0.1},
                         {1e-320, 1e300},
                         {Limits::infinity(), -Limits::infinity()},
                         {Limits::quiet_NaN(), std::bit_cast<double>(0xFFF8000000000123U)}}};
  numbers.trace = {{{1, 2, 3}, 0.1, Limits::infinity()}, {{4, 5, 6}, 1e-9, 28.627416997969522}};
  numbers.counters = {{"arrived", std::numeric_limits<std::uint64_t>::max()}, {"pops", 0}};
  numbers.digest = 0x0000000000000001U;
  numbers.timed = true;
  rows.push_back(numbers);

  TrialRow texts = failed_row(0x8000000000000000U, "as:a=1,b=\"2\"", "curated/\xC3\xA9t\xC3\xA9, 'x'");
  texts.note = "line one\nline two\ttab, comma \"quote\" ";
  texts.note += '\0';
  texts.note += " nul";
  texts.call = "";
  texts.track = Track::any_angle;
  texts.rule = MoveRule::squeeze;
  texts.verdict = Verdict::invalid;
  texts.version = 7;
  texts.optimum = std::nullopt;
  texts.answer = Path{};
  texts.draws = false;
  rows.push_back(texts);

  TrialRow run = run_row(0x4000000000000000U, "straight", "discs/open/1");
  run.run->min_clearance = -1.0 / 3;
  run.run->collisions = std::numeric_limits<std::uint64_t>::max();
  rows.push_back(run);
  run.key = 0x4000000000000001U;
  run.run->min_clearance = std::nullopt;
  run.least_steps = std::nullopt;
  run.costs.step_ms_median = std::nullopt;
  rows.push_back(run);
  return rows;
}

inline std::string bits(const std::optional<double>& value) {
  return value ? hex(std::bit_cast<std::uint64_t>(*value)) : "none";
}
inline std::string bits(const TracePoint& point) {
  return std::to_string(point.work.evaluations) + "," + std::to_string(point.work.iterations) + "," +
         std::to_string(point.work.checks) + "," + bits(point.wall_s) + "," + bits(point.cost);
}

inline void expect_same_slim(const TrialRow& a, const TrialRow& b) {
  SCOPED_TRACE("key " + hex(a.key));
  EXPECT_EQ(a.key, b.key);
  EXPECT_EQ(a.scenario, b.scenario);
  EXPECT_EQ(a.planner, b.planner);
  EXPECT_EQ(a.call, b.call);
  EXPECT_EQ(a.version, b.version);
  EXPECT_EQ(a.repetition, b.repetition);
  EXPECT_EQ(a.seed, b.seed);
  EXPECT_EQ(a.budget, b.budget);
  EXPECT_EQ(a.verdict, b.verdict);
  EXPECT_EQ(a.note, b.note);
  EXPECT_EQ(a.track, b.track);
  EXPECT_EQ(a.rule, b.rule);
  EXPECT_EQ(bits(a.length), bits(b.length));
  EXPECT_EQ(bits(a.optimum), bits(b.optimum));
  EXPECT_EQ(bits(a.gap), bits(b.gap));
  EXPECT_EQ(a.turns, b.turns);
  EXPECT_EQ(bits(a.turn_angle), bits(b.turn_angle));
  EXPECT_EQ(bits(a.clearance_min), bits(b.clearance_min));
  EXPECT_EQ(bits(a.clearance_mean), bits(b.clearance_mean));
  EXPECT_EQ(a.work, b.work);
  EXPECT_EQ(a.digest, b.digest);
  EXPECT_EQ(a.timed, b.timed);
  EXPECT_EQ(bits(a.costs.wall_s), bits(b.costs.wall_s));
  EXPECT_EQ(bits(a.costs.setup_s), bits(b.costs.setup_s));
  EXPECT_EQ(a.costs.backend, b.costs.backend);
  EXPECT_EQ(a.costs.threads, b.costs.threads);
  EXPECT_EQ(a.costs.threads_used, b.costs.threads_used);
  EXPECT_EQ(a.costs.crowded, b.costs.crowded);
  EXPECT_EQ(a.run, b.run);
  EXPECT_EQ(a.least_steps, b.least_steps);
  EXPECT_EQ(bits(a.costs.step_ms_median), bits(b.costs.step_ms_median));
  EXPECT_EQ(bits(a.costs.step_ms_p99), bits(b.costs.step_ms_p99));
  EXPECT_EQ(bits(a.costs.user_s), bits(b.costs.user_s));
  EXPECT_EQ(bits(a.costs.system_s), bits(b.costs.system_s));
  EXPECT_EQ(a.session, b.session);
  EXPECT_EQ(a.draws, b.draws);
}

inline void expect_same(const TrialRow& a, const TrialRow& b) {
  expect_same_slim(a, b);
  SCOPED_TRACE("key " + hex(a.key));
  ASSERT_EQ(a.answer.has_value(), b.answer.has_value());
  if (a.answer) {
    EXPECT_EQ(a.answer->track, b.answer->track);
    ASSERT_EQ(a.answer->points.size(), b.answer->points.size());
    for (std::size_t i = 0; i < a.answer->points.size(); ++i) {
      EXPECT_EQ(bits(a.answer->points[i].x), bits(b.answer->points[i].x));
      EXPECT_EQ(bits(a.answer->points[i].y), bits(b.answer->points[i].y));
    }
  }
  ASSERT_EQ(a.trace.size(), b.trace.size());
  for (std::size_t i = 0; i < a.trace.size(); ++i) EXPECT_EQ(bits(a.trace[i]), bits(b.trace[i]));
  EXPECT_EQ(a.counters, b.counters);
}

inline std::vector<TrialRow> all_rows(const Store& store) {
  std::vector<TrialRow> rows;
  store.for_each([&rows](const TrialRow& row) { rows.push_back(row); });
  return rows;
}

/// What the exception that `action` throws says; empty, and a failure, when it throws none of this type.
template <typename Error, typename Action>
std::string message_of(const Action& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  ADD_FAILURE() << "no such exception was thrown";
  return "";
}

/// One line that holds every one of these pieces.
inline void expect_line(const std::string& message, const std::vector<std::string>& pieces) {
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  for (const std::string& piece : pieces) {
    EXPECT_NE(message.find(piece), std::string::npos) << "no '" << piece << "' in: " << message;
  }
}

}  // namespace pathrace::results
