// OMPL through the adapter, beside a plain loop with sampled motions.
//
// dense/20-20/<seed>, the same seeds on both sides, so that the planners meet the same samples. RRT-Connect
// runs until it is solved; RRT* asks 2000 times whether to stop. The time is that of a whole run, set-up
// included; `per_check` is the time per lookup of a cell on either side (a sampled motion looks a cell up
// many times), `per_evaluation` the time per question of the planner, about a point or a whole motion.
#ifdef PATHRACE_OMPL

#include <benchmark/benchmark.h>

#include <memory>
#include <string>
#include <vector>

#include "baselines/ompl/plain_loop.hpp"
#include "bench/executors.hpp"
#include "bench/roster.hpp"
#include "scenarios/library.hpp"

namespace pathrace::bench::micro {
namespace {

constexpr std::uint64_t rounds = 2000;

const std::vector<Scenario>& maps() {
  static const std::vector<Scenario> all = [] {
    std::vector<Scenario> scenarios;
    for (int seed = 1; seed <= 20; ++seed) {
      scenarios.push_back(scenarios::Library().load("dense/20-20/" + std::to_string(seed)));
    }
    return scenarios;
  }();
  return all;
}

// Seconds per item, printed with a unit.
benchmark::Counter time_per(std::uint64_t items) {
  return {static_cast<double>(items), benchmark::Counter::kIsRate | benchmark::Counter::kInvert};
}

void ompl_adapter(benchmark::State& state, const std::string& call) {
  const Entrant entrant = roster().enter(parse_call(call));
  const std::unique_ptr<Executor> executor = make_executor("serial", 1);
  std::uint64_t run = 0;
  Work work;
  for (auto _ : state) {
    const Scenario& map = maps()[run % maps().size()];
    Budget budget;
    budget.iterations = rounds;
    Meter meter(budget);
    Context context{Stream(1).fork(run++), *executor, meter};
    benchmark::DoNotOptimize(
        entrant.card->make(entrant.values)(map.terrain)->plan(map.start, map.goal, context));
    work.evaluations += meter.work().evaluations;
    work.checks += meter.work().checks;
  }
  state.counters["per_check"] = time_per(work.checks);
  state.counters["per_evaluation"] = time_per(work.evaluations);
}

void ompl_plain(benchmark::State& state, baselines::PlainPlanner planner) {
  std::uint64_t run = 0;
  std::uint64_t lookups = 0;
  for (auto _ : state) {
    const Scenario& map = maps()[run % maps().size()];
    const Problem problem{map.grid(), map.terrain.rule, map.start, map.goal};
    lookups += baselines::plain_loop(planner, problem, Stream(1).fork(run++), rounds).lookups;
  }
  state.counters["per_check"] = time_per(lookups);
}

BENCHMARK_CAPTURE(ompl_plain, rrt_connect, baselines::PlainPlanner::rrt_connect)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(ompl_adapter, rrt_connect, "ompl-rrt-connect")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(ompl_plain, rrt_star, baselines::PlainPlanner::rrt_star)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(ompl_adapter, rrt_star, "ompl-rrt-star")->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace pathrace::bench::micro

#endif
