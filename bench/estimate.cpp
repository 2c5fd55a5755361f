#include "bench/estimate.hpp"

#include <algorithm>
#include <bit>
#include <chrono>
#include <map>
#include <thread>
#include <utility>

#include "bench/executors.hpp"
#include "bench/trial.hpp"
#include "core/referee.hpp"

namespace pathrace::bench {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double pilot_limit_s = 0.15;
constexpr double all_pilots_s = 2.0;
constexpr std::size_t rounds = 3;
constexpr double unknown_share =
    0.1;  // of its work that a cut trial without a work budget is taken to have done

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

// Trials that cost about the same: one planner, one budget, one order of magnitude of map size.
struct Group {
  std::size_t entrant = 0;
  double cells = 0;
  std::vector<std::size_t> trials;     // indices into the plan
  std::vector<std::size_t> positions;  // of the same trials in the list that was asked about
  double measured_s = 0;               // sum over the pilots
  std::size_t pilots = 0;

  double trial_s() const { return measured_s / static_cast<double>(pilots); }
};

std::vector<Group> groups_of(const TrialPlan& plan, const std::vector<std::size_t>& trials) {
  std::map<std::pair<std::size_t, int>, Group> groups;
  for (std::size_t position = 0; position < trials.size(); ++position) {
    const std::size_t index = trials[position];
    const Trial& trial = plan.trials[index];
    const OccupancyGrid& grid = plan.scenarios[trial.scenario].grid();
    const auto cells = static_cast<std::uint64_t>(grid.width()) * static_cast<std::uint64_t>(grid.height());
    Group& group = groups[{trial.entrant, std::bit_width(cells) / 2}];
    group.entrant = trial.entrant;
    group.cells = std::max(group.cells, static_cast<double>(cells));
    group.trials.push_back(index);
    group.positions.push_back(position);
  }
  std::vector<Group> list;
  for (auto& entry : groups) list.push_back(std::move(entry.second));
  std::sort(list.begin(), list.end(), [](const Group& a, const Group& b) {
    return a.cells * static_cast<double>(a.trials.size()) > b.cells * static_cast<double>(b.trials.size());
  });
  return list;
}

double share_spent(const Work& work, const Budget& budget) {
  double share = 0;
  const auto consider = [&share](const std::optional<std::uint64_t>& limit, std::uint64_t spent) {
    if (limit) share = std::max(share, static_cast<double>(spent) / static_cast<double>(*limit));
  };
  consider(budget.evaluations, work.evaluations);
  consider(budget.iterations, work.iterations);
  consider(budget.checks, work.checks);
  return share > 0 ? std::min(share, 1.0) : unknown_share;
}

double measure(const TrialPlan& plan, const Trial& trial, const RunOptions& options) {
  const Clock::time_point begin = Clock::now();
  Budget budget = trial.budget;
  budget.wall_s = std::min(budget.wall_s.value_or(pilot_limit_s), pilot_limit_s);
  const Scenario& scenario = plan.scenarios[trial.scenario];
  const Referee referee(scenario.terrain);
  const std::unique_ptr<Executor> executor = make_executor(options.backend, options.threads);
  const Stream stream = root_stream(trial.key.seed, trial.key.scenario, trial.key.repetition);
  const double ready = seconds_since(begin);
  const TrialRecord record =
      run_trial(plan.entrants[trial.entrant], scenario, referee, budget, stream, *executor);
  const double judged = seconds_since(begin) - ready - record.costs.wall_s;
  const bool stopped = record.timed && record.costs.wall_s >= *budget.wall_s;
  const bool cut = stopped && !(trial.budget.wall_s && *trial.budget.wall_s <= pilot_limit_s);
  double planned = cut ? record.costs.wall_s / share_spent(record.work, trial.budget) : record.costs.wall_s;
  if (trial.budget.wall_s) planned = std::min(planned, *trial.budget.wall_s);
  return ready / 10 + planned + judged;  // referee and optimum are shared by a scenario's trials
}

// A group nobody measured costs what the same planner's nearest measured group costs, by the number of cells.
double borrowed(const Group& group, const std::vector<Group>& groups) {
  double best = 0;
  for (const Group& other : groups) {
    if (other.pilots == 0) continue;
    const double scaled = other.trial_s() * group.cells / other.cells;
    if (other.entrant == group.entrant) return scaled;
    best = std::max(best, scaled);
  }
  return best;
}

// How many ran.
std::size_t run_pilots(const TrialPlan& plan, const RunOptions& options, std::vector<Group>& groups) {
  const Clock::time_point begin = Clock::now();
  std::size_t pilots = 0;
  for (std::size_t round = 0; round < rounds; ++round) {
    for (Group& group : groups) {
      if (seconds_since(begin) > all_pilots_s) return pilots;
      if (group.pilots >= group.trials.size()) continue;
      const std::size_t place = group.trials.size() * (2 * ((round + 1) % rounds) + 1) / (2 * rounds);
      group.measured_s += measure(plan, plan.trials[group.trials[place]], options);
      ++group.pilots;
      ++pilots;
    }
  }
  return pilots;
}

}  // namespace

Estimate estimate_time(const TrialPlan& plan, const std::vector<std::size_t>& trials,
                       const RunOptions& options) {
  std::vector<Group> groups = groups_of(plan, trials);
  Estimate estimate;
  estimate.pilots = run_pilots(plan, options, groups);
  estimate.trial_s.resize(trials.size());
  double work_s = 0;
  for (const Group& group : groups) {
    const double trial_s = group.pilots > 0 ? group.trial_s() : borrowed(group, groups);
    for (const std::size_t position : group.positions) estimate.trial_s[position] = trial_s;
    work_s += trial_s * static_cast<double>(group.trials.size());
  }
  const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  const int jobs = make_executor(options.backend, options.jobs)->threads();
  estimate.wall_s = work_s / std::min(jobs, cores);
  return estimate;
}

}  // namespace pathrace::bench
