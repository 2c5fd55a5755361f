#include "bench/dynamic_trial.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "bench/guarded.hpp"
#include "bench/ticker.hpp"
#include "bench/trial_surroundings.hpp"
#include "core/checkpoint.hpp"
#include "core/error.hpp"
#include "core/hash.hpp"
#include "core/run_referee.hpp"
#include "core/world_motion.hpp"
#include "results/median.hpp"

namespace pathrace::bench {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

Snapshot snapshot_of(const World& world, const WorldMotion& motion, Point robot, std::uint64_t step) {
  return {world.width,   world.height,   robot, world.robot_radius, world.robot_step, motion.goal(),
          world.arrival, motion.discs(), step};
}

bool is_position(Point point) {
  return std::isfinite(point.x) && std::isfinite(point.y);
}

// One run, step by step, in the order of Algorithm 2.
class Run {
 public:
  Run(const World& world, const Stream& stream, Executor& executor, Meter& meter, const WatchStep& watch)
      : world_(world), stream_(stream), executor_(executor), meter_(meter), watch_(watch), motion_(world) {}

  /// The robot's positions so far, also when the navigator throws.
  const std::vector<Point>& points() const { return points_; }
  const std::vector<double>& step_ms() const { return step_ms_; }

  void drive(Navigator& navigator) {
    for (std::uint64_t step = 0; step < world_.max_steps; ++step) {
      const Point robot = points_.back();
      const bool arrived = straight_line(robot, motion_.goal()) <= world_.arrival;
      if (arrived || !is_position(robot) || meter_.exhausted()) return;
      motion_.advance(robot);
      points_.push_back(step_of(navigator, snapshot_of(world_, motion_, robot, step)));
      meter_.end_iteration();
      meter_.improved(straight_line(points_.back(), motion_.goal()));
    }
  }

  /// Of the world that the navigator saw.
  std::uint64_t hash_of_what_was_seen() { return motion_.hash_to_the_end(); }

 private:
  Point step_of(Navigator& navigator, const Snapshot& snapshot) {
    Overlay overlay;
    Context context{stream_.fork(snapshot.step), executor_, meter_, watch_ ? &overlay : nullptr};
    const Clock::time_point begin = Clock::now();
    const Point next = navigator.next(snapshot, context);
    step_ms_.push_back(1000 * seconds_since(begin));
    if (watch_) watch_(snapshot, next, overlay);
    return next;
  }

  const World& world_;
  Stream stream_;
  Executor& executor_;
  Meter& meter_;
  const WatchStep& watch_;
  WorldMotion motion_;
  std::vector<Point> points_{world_.start};
  std::vector<double> step_ms_;
};

void add_step_times(std::vector<double> times, Costs& costs) {
  if (times.empty()) return;
  std::sort(times.begin(), times.end());
  costs.step_ms_p99 = times[(99 * times.size() + 99) / 100 - 1];
  costs.step_ms_median = results::median(std::move(times));
}

std::string budget_fault(const Meter& meter) {
  if (!meter.exceeded()) return "";
  return fmt::format("the budget was exceeded: {} evaluations, {} iterations, {} checks",
                     meter.work().evaluations, meter.work().iterations, meter.work().checks);
}

void judge(const World& world, std::uint64_t seen, const Meter& meter, TrialRecord& record) {
  RunJudgement judgement = judge_run(world, record.answer->points);
  std::string fault = std::move(judgement.fault);
  if (fault.empty() && seen != world.hash) {
    fault =
        fmt::format("the navigator meddled with the world: hash {}, expected {}", hex(seen), hex(world.hash));
  }
  if (fault.empty()) fault = budget_fault(meter);
  if (!fault.empty()) {
    record.verdict = Verdict::invalid;
    record.note = std::move(fault);
    return;
  }
  record.run = judgement.metrics;
  record.run->world_hash = seen;
  if (!judgement.arrived) {
    record.verdict = Verdict::budget;
    record.note = fmt::format("not arrived after {} steps", judgement.metrics.steps);
  } else if (judgement.metrics.collisions > 0) {
    record.verdict = Verdict::invalid;
    record.note = fmt::format("{} collision{}, the first in {}", judgement.metrics.collisions,
                              judgement.metrics.collisions == 1 ? "" : "s", judgement.collision);
  } else {
    record.verdict = Verdict::solved;
  }
}

// True when the navigator drove to the end of the run.
bool call_navigator(const Entrant& entrant, Run& run, TrialRecord& record) {
  const Clock::time_point begin = Clock::now();
  bool came_back = false;
  guarded(record, [&] {
    if (!entrant.card->navigates()) throw Unsupported("plans on maps that stand still; these discs move");
    const std::unique_ptr<Navigator> navigator = entrant.card->make_navigator(entrant.values)();
    record.costs.setup_s = seconds_since(begin);
    run.drive(*navigator);
    came_back = true;
  });
  record.costs.wall_s = seconds_since(begin);
  return came_back;
}

}  // namespace

TrialRecord run_dynamic_trial(const Entrant& entrant, const World& world, const Budget& budget,
                              const Stream& stream, Executor& executor, const WatchStep& watch,
                              Ticker* ticker) {
  TrialRecord record;
  Meter meter(budget);
  const Ticker::Watch shown(ticker, meter);
  executor.restart_census();
  Run run(world, stream, executor, meter, watch);
  bool came_back = false;
  {
    const TrialSurroundings surroundings(executor, record.costs);
    executor.with_team([&] {
      const TrialScope scope(meter);
      came_back = call_navigator(entrant, run, record);
    });
  }
  if (meter.interrupted()) throw Interrupted();
  record.work = meter.work();
  record.trace = meter.trace();
  record.counters = meter.counters();
  record.timed = meter.timed();
  record.costs.threads_used = executor.threads_used();
  add_step_times(run.step_ms(), record.costs);
  if (came_back) {
    record.answer = Path{Track::dynamic, run.points()};
    judge(world, run.hash_of_what_was_seen(), meter, record);
  }
  return record;
}

}  // namespace pathrace::bench
