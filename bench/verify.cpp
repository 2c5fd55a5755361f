#include "bench/verify.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <mutex>
#include <unordered_map>

#include "core/hash.hpp"
#include "results/counters_text.hpp"
#include "scenarios/movingai/folder.hpp"

namespace pathrace::bench {
namespace {

using results::TrialRow;

std::string row_name(const TrialRow& row) {
  return fmt::format("row {} ({}, {}, repetition {})", hex(row.key), row.scenario, row.planner,
                     row.repetition);
}

std::string text(const std::optional<double>& value) {
  return value ? fmt::format("{}", *value) : "none";
}
std::string text(const std::optional<int>& value) {
  return value ? fmt::format("{}", *value) : "none";
}
std::string text(const std::optional<std::uint64_t>& value) {
  return value ? fmt::format("{}", *value) : "none";
}
std::string text(std::uint64_t value) {
  return fmt::format("{}", value);
}
std::string text(const std::string& value) {
  return fmt::format("'{}'", value);
}

// A run's figures as text: exact, and equal where they are.
std::string run_text(const std::optional<RunMetrics>& run) {
  if (!run) return "none";
  return fmt::format(
      "{} steps, {} travelled, {} collisions, {} struck, clearance {}, {} oscillations, world {}", run->steps,
      run->travelled, run->collisions, run->struck, text(run->min_clearance), run->oscillations,
      hex(run->world_hash));
}

// What two rows of the same trial differ in, first column first; empty when they agree.
std::string first_difference(const TrialRow& stored, const TrialRow& rerun) {
  std::string found;
  const auto compare = [&found](std::string_view column, const auto& a, const auto& b) {
    if (found.empty() && !(a == b))
      found = fmt::format("{}: stored {}, run again {}", column, text(a), text(b));
  };
  compare("scenario", stored.scenario, rerun.scenario);
  compare("planner", stored.planner, rerun.planner);
  compare("call", stored.call, rerun.call);
  compare("version", static_cast<std::uint64_t>(stored.version), static_cast<std::uint64_t>(rerun.version));
  compare("repetition", stored.repetition, rerun.repetition);
  compare("seed", stored.seed, rerun.seed);
  compare("budget", stored.budget, rerun.budget);
  compare("verdict", std::string(name(stored.verdict)), std::string(name(rerun.verdict)));
  compare("note", stored.note, rerun.note);
  compare("track", std::string(name(stored.track)), std::string(name(rerun.track)));
  compare("rule", std::string(name(stored.rule)), std::string(name(rerun.rule)));
  compare("length", stored.length, rerun.length);
  compare("optimum", stored.optimum, rerun.optimum);
  compare("gap", stored.gap, rerun.gap);
  compare("turns", stored.turns, rerun.turns);
  compare("turn_angle", stored.turn_angle, rerun.turn_angle);
  compare("clearance_min", stored.clearance_min, rerun.clearance_min);
  compare("clearance_mean", stored.clearance_mean, rerun.clearance_mean);
  compare("run", run_text(stored.run), run_text(rerun.run));
  compare("least_steps", stored.least_steps, rerun.least_steps);
  compare("evaluations", stored.work.evaluations, rerun.work.evaluations);
  compare("iterations", stored.work.iterations, rerun.work.iterations);
  compare("checks", stored.work.checks, rerun.work.checks);
  compare("path", stored.answer ? results::print_points(*stored.answer) : "",
          rerun.answer ? results::print_points(*rerun.answer) : "");
  compare("counters", results::print_counters(stored.counters), results::print_counters(rerun.counters));
  compare("digest", hex(stored.digest), hex(rerun.digest));
  return found;
}

// Everything but costs, in one number; rows that agree in it are not looked at again.
std::uint64_t fingerprint(const TrialRow& row) {
  Hasher hasher;
  const auto add = [&hasher](const auto& value) {
    hasher.add(std::uint64_t{value ? 1U : 0U});
    if (value) hasher.add(*value);
  };
  for (const std::string* part : {&row.scenario, &row.planner, &row.call, &row.budget, &row.note}) {
    hasher.add(std::string_view(*part));
  }
  hasher.add(row.version).add(row.repetition).add(row.seed);
  hasher.add(name(row.verdict)).add(name(row.track)).add(name(row.rule));
  for (const auto* metric :
       {&row.length, &row.optimum, &row.gap, &row.turn_angle, &row.clearance_min, &row.clearance_mean}) {
    add(*metric);
  }
  add(row.turns);
  add(row.least_steps);
  hasher.add(std::string_view(run_text(row.run)));
  hasher.add(std::string_view(results::print_counters(row.counters)));
  return hasher.add(row.digest).add(results::recomputed_digest(row)).value();
}

class Verifier {
 public:
  Verifier(const TrialPlan& plan, Verification& result) : plan_(plan), result_(result) {
    for (std::size_t i = 0; i < plan.size(); ++i) trial_of_[plan.trial(i).hash] = i;
  }

  void read(const results::Store& store) {
    store.inspect([this](const TrialRow& row) {
      ++result_.rows;
      if (row.altered) differ(row, "changed after it was recorded");
      const auto trial = trial_of_.find(row.key);
      if (trial == trial_of_.end()) return differ(row, "the campaign has no trial with this key");
      const std::uint64_t own = results::recomputed_digest(row);
      if (own != row.digest) {
        return differ(row,
                      fmt::format("digest {} does not fit the stored path, work and trace, which give {}",
                                  hex(row.digest), hex(own)));
      }
      if (row.timed || !plan_.entrants[plan_.group_of(trial->second).entrant].card->deterministic) {
        ++result_.skipped;
        return;
      }
      candidates_.push_back(trial->second);
      stored_[row.key] = fingerprint(row);
    });
  }

  void run_again(const results::Store& store, std::optional<std::size_t> sample, const RunOptions& options) {
    std::vector<std::size_t> chosen;
    for (const std::size_t i : scenarios::spread(candidates_.size(), sample.value_or(candidates_.size()))) {
      chosen.push_back(candidates_[i]);
    }
    std::sort(chosen.begin(), chosen.end());  // trials on one scenario side by side, as in a run
    const std::atomic<bool> never{false};
    run_trials(plan_, chosen, options, never,
               [this](const Trial& trial, const Scenario& scenario, const TrialRecord& record) {
                 TrialRow row = results::make_row(trial.key, scenario, plan_.entrants[trial.entrant],
                                                  trial.budget, record);
                 const bool equal = fingerprint(row) == stored_.at(trial.hash);
                 const std::lock_guard lock(mutex_);
                 ++result_.rerun;
                 if (!equal) unequal_.emplace(trial.hash, std::move(row));
               });
    if (unequal_.empty()) return;
    store.inspect([this](const TrialRow& row) {
      const auto again = unequal_.find(row.key);
      if (again == unequal_.end()) return;
      differ(row, first_difference(row, again->second));
    });
  }

 private:
  void differ(const TrialRow& row, const std::string& what) {
    result_.differences.push_back(fmt::format("{}: {}", row_name(row), what));
  }

  const TrialPlan& plan_;
  Verification& result_;
  std::unordered_map<std::uint64_t, std::size_t> trial_of_;
  std::vector<std::size_t> candidates_;
  std::mutex mutex_;
  std::unordered_map<std::uint64_t, std::uint64_t> stored_;  // fingerprints by key
  std::unordered_map<std::uint64_t, TrialRow> unequal_;      // as run again, by key
};

}  // namespace

Verification verify(const results::Store& store, const TrialPlan& plan, std::optional<std::size_t> sample,
                    const RunOptions& options) {
  Verification result;
  Verifier verifier(plan, result);
  verifier.read(store);
  verifier.run_again(store, sample, options);
  return result;
}

}  // namespace pathrace::bench
