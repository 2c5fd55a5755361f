// Evaluations of the genetic algorithm per second, and the cost function alone.
//
// An item is an evaluation, all in: selection, crossover, mutation, insertion, deletion, fitness, its share
// of the elite and of the set-up on the map. `cost` is what of that the fitness function takes, on the path
// that the planner answers with. Maps: the paper's fig. 2 (5 x 5) and dense/20-20/1, strict corners.
#include <benchmark/benchmark.h>

#include <memory>
#include <string>
#include <vector>

#include "algorithms/ga/fitness.hpp"
#include "bench/executors.hpp"
#include "bench/roster.hpp"
#include "scenarios/library.hpp"

namespace pathrace::bench::micro {
namespace {

constexpr std::uint64_t evaluations = 20'000;
constexpr const char* paper = "xie2010";
constexpr const char* any_map =
    "xie2010:insertion=general,repair=local_search,initial_genes=8,mutation=stretch,mutation_rate=0.5";

Answer evolve_once(const Scenario& scenario, const std::string& call, Executor& executor) {
  const Entrant entrant = roster().enter(parse_call(call));
  const std::unique_ptr<MapPlanner> planner = entrant.card->make(entrant.values)(scenario.terrain);
  Budget budget;
  budget.evaluations = evaluations;
  Meter meter(budget);
  Context context{Stream(1), executor, meter};
  return planner->plan(scenario.start, scenario.goal, context);
}

void ga(benchmark::State& state, const char* map, const std::string& call, const std::string& backend) {
  const Scenario scenario = scenarios::Library().load(map);
  const std::unique_ptr<Executor> executor = make_executor(backend, static_cast<int>(state.range(0)));
  executor->with_team([&] {
    for (auto _ : state) benchmark::DoNotOptimize(evolve_once(scenario, call, *executor));
  });
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(evaluations));
}

void ga_cost(benchmark::State& state, const char* map, const std::string& call) {
  const Scenario scenario = scenarios::Library().load(map);
  const OccupancyGrid& grid = scenario.grid();
  const std::unique_ptr<Executor> executor = make_executor("serial", 1);
  const Answer answer = evolve_once(scenario, call, *executor);
  std::vector<algorithms::Gene> genes;
  for (const Point point : answer.value().points) {
    const Cell cell{static_cast<int>(point.x), static_cast<int>(point.y)};
    genes.push_back(static_cast<algorithms::Gene>(grid.index(cell)));
  }
  for (auto _ : state) {
    benchmark::DoNotOptimize(genes.data());
    const LatticeLength length = algorithms::step_counts(genes, grid.stride());
    benchmark::DoNotOptimize(algorithms::fitness(genes.size(), length.value()));
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations());
  state.counters["cells"] = static_cast<double>(genes.size());
}

BENCHMARK_CAPTURE(ga_cost, paper_5x5, "asr/fig2", paper);
BENCHMARK_CAPTURE(ga_cost, any_map_20x20, "dense/20-20/1", any_map);
BENCHMARK_CAPTURE(ga, paper_5x5, "asr/fig2", paper, "serial")->Arg(1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(ga, any_map_20x20, "dense/20-20/1", any_map, "serial")
    ->Arg(1)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(ga, paper_5x5_openmp, "asr/fig2", paper, "openmp")
    ->Arg(2)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(ga, any_map_20x20_openmp, "dense/20-20/1", any_map, "openmp")
    ->Arg(2)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(ga, population_400_openmp, "dense/20-20/1", std::string(any_map) + ",population=400",
                  "openmp")
    ->Arg(1)
    ->Arg(2)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(ga, population_400_tbb, "dense/20-20/1", std::string(any_map) + ",population=400", "tbb")
    ->Arg(1)
    ->Arg(2)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pathrace::bench::micro
