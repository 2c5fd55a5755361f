// Ant steps per second, and whole colonies.
//
// An item is a decision of an ant, all in: choice, marks, its share of deposits and evaporation, and of the
// trail's set-up. Every colony walks 50 ants x 100 iterations (20 on the largest map) of `as` with its
// defaults; maps are dense/<n>-20/1, 20 % blocked, strict corners.
#include <benchmark/benchmark.h>

#include <memory>
#include <string>

#include "bench/executors.hpp"
#include "bench/micro/plain_ants.hpp"
#include "bench/roster.hpp"
#include "scenarios/library.hpp"

namespace pathrace::bench::micro {
namespace {

constexpr std::size_t ants = 50;

std::uint64_t iterations_on(int side) {
  return side > 200 ? 20 : 100;
}

Scenario dense(int side) {
  return scenarios::Library().load("dense/" + std::to_string(side) + "-20/1");
}

void colony(benchmark::State& state, const std::string& call, const std::string& backend) {
  const auto side = static_cast<int>(state.range(0));
  const auto threads = static_cast<int>(state.range(1));
  const Scenario scenario = dense(side);
  const Entrant entrant = roster().enter(parse_call(call));
  const std::unique_ptr<MapPlanner> planner = entrant.card->make(entrant.values)(scenario.terrain);
  const std::unique_ptr<Executor> executor = make_executor(backend, threads);
  Budget budget;
  budget.iterations = iterations_on(side);
  std::uint64_t decisions = 0;
  executor->with_team([&] {
    for (auto _ : state) {
      Meter meter(budget);
      Context context{Stream(1), *executor, meter};
      benchmark::DoNotOptimize(planner->plan(scenario.start, scenario.goal, context));
      decisions += meter.work().checks;
    }
  });
  state.SetItemsProcessed(static_cast<std::int64_t>(decisions));
}

void plain_colony(benchmark::State& state, bool backtrack) {
  const auto side = static_cast<int>(state.range(0));
  const Scenario scenario = dense(side);
  const Problem problem{*scenario.terrain.grid, scenario.terrain.rule, scenario.start, scenario.goal};
  std::uint64_t decisions = 0;
  std::vector<PlainWalk> walks(ants);
  for (auto _ : state) {
    PlainColony colony(problem, 7, backtrack);
    for (std::uint64_t iteration = 0; iteration < iterations_on(side); ++iteration) {
      const Stream stream = Stream(1).fork(iteration);
      for (std::size_t i = 0; i < ants; ++i) {
        walks[i] = colony.walk(stream.fork(i));
        decisions += walks[i].decisions;
      }
      colony.learn(walks, 0.7);
    }
    benchmark::DoNotOptimize(colony);
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(decisions));
}

BENCHMARK_CAPTURE(plain_colony, die, false)->Arg(20)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(colony, die, "as", "serial")->Args({20, 1})->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(plain_colony, backtrack, true)->Arg(20)->Arg(100)->Arg(512)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(colony, backtrack, "as:dead_end=backtrack", "serial")
    ->Args({20, 1})
    ->Args({100, 1})
    ->Args({512, 1})
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(colony, openmp, "as:dead_end=backtrack", "openmp")
    ->Args({20, 1})
    ->Args({20, 2})
    ->Args({100, 2})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(colony, tbb, "as:dead_end=backtrack", "tbb")
    ->Args({20, 1})
    ->Args({20, 2})
    ->Args({100, 2})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pathrace::bench::micro
