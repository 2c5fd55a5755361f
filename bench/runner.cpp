#include "bench/runner.hpp"

#include <memory>
#include <mutex>
#include <set>
#include <utility>

#include "bench/executors.hpp"
#include "bench/reference.hpp"
#include "bench/trial.hpp"
#include "core/checkpoint.hpp"
#include "core/referee.hpp"

namespace pathrace::bench {
namespace {

// What all trials on a scenario share: the references of their tracks and its referee. Made by the first
// trial that needs them, dropped after the last, so that a large campaign does not hold every map's distance
// transform.
class ScenarioDesk {
 public:
  void expect_one(Track track) {
    ++pending_;
    tracks_.insert(track);
  }

  std::pair<const Scenario*, const Referee*> open(const Scenario& scenario) {
    const std::lock_guard lock(mutex_);
    if (!referee_) {
      auto referee = std::make_unique<Referee>(scenario.terrain);
      scenario_ = scenario;
      for (const Track track : tracks_) prove_reference(scenario_, track, *referee);
      referee_ = std::move(referee);  // all is proven: an interrupted proof leaves nothing half done
    }
    return {&scenario_, referee_.get()};
  }

  void close_one() {
    const std::lock_guard lock(mutex_);
    if (--pending_ > 0) return;
    referee_.reset();
    scenario_ = Scenario{};
  }

 private:
  std::mutex mutex_;
  std::size_t pending_ = 0;
  std::set<Track> tracks_;
  Scenario scenario_;
  std::unique_ptr<Referee> referee_;
};

// Executors for planners, one for each trial that runs at the moment; a pool's threads outlive the trial.
class ExecutorShelf {
 public:
  ExecutorShelf(std::string backend, int threads) : backend_(std::move(backend)), threads_(threads) {}

  std::unique_ptr<Executor> take() {
    {
      const std::lock_guard lock(mutex_);
      if (!free_.empty()) {
        std::unique_ptr<Executor> executor = std::move(free_.back());
        free_.pop_back();
        return executor;
      }
    }
    return make_executor(backend_, threads_);
  }

  void give_back(std::unique_ptr<Executor> executor) {
    const std::lock_guard lock(mutex_);
    free_.push_back(std::move(executor));
  }

 private:
  std::string backend_;
  int threads_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<Executor>> free_;
};

// Of threads that come and go between trials nobody can say whose processor time is whose.
void add_neighbours(bool side_by_side, int threads, Costs& costs) {
  if (!side_by_side) return;
  costs.crowded = true;
  if (threads > 1) costs.user_s = costs.system_s = std::nullopt;
}

}  // namespace

void run_trials(const TrialPlan& plan, const std::vector<std::size_t>& trials, const RunOptions& options,
                const std::atomic<bool>& stop, const Sink& sink) {
  std::vector<ScenarioDesk> desks(plan.scenarios.size());
  for (const std::size_t index : trials) {
    const TrialGroup& group = plan.group_of(index);
    desks[group.scenario].expect_one(plan.entrants[group.entrant].card->track);
  }
  ExecutorShelf shelf(options.backend, options.threads);
  const std::unique_ptr<Executor> across = make_executor(options.backend, options.jobs);
  const bool side_by_side = across->threads() > 1 && trials.size() > 1;
  const auto run_one = [&](const Trial& trial) {
    ScenarioDesk& desk = desks[trial.scenario];
    const auto [scenario, referee] = desk.open(plan.scenarios[trial.scenario]);
    std::unique_ptr<Executor> executor = shelf.take();
    const Stream stream = root_stream(trial.key.seed, trial.key.scenario, trial.key.repetition);
    TrialRecord record = run_trial(plan.entrants[trial.entrant], *scenario, *referee, trial.budget, stream,
                                   *executor, nullptr, nullptr, options.check_map);
    record.key = trial.hash;
    record.costs.backend = options.backend;
    record.costs.threads = options.threads;
    add_neighbours(side_by_side, options.threads, record.costs);
    shelf.give_back(std::move(executor));
    sink(trial, *scenario, std::move(record));
    desk.close_one();
  };
  for_each_index(*across, trials.size(), 1, [&](std::size_t i) {
    if (stop.load(std::memory_order_relaxed)) return;
    try {
      run_one(plan.trial(trials[i]));
    } catch (const Interrupted&) {  // not recorded; a resumed run runs it again
    }
  });
}

}  // namespace pathrace::bench
