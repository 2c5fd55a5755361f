// Particles judged per second: the cost of a way-point path alone, and whole swarms.
//
// An item is one evaluation. Paths have 8 way-points on dense/20-20/1, 20 x 20 cells, 20 % blocked. `cost`
// judges 1024 paths: `uniform`, way-points anywhere on the map; `line`, near the straight line as a swarm is
// born; `evolved`, of a swarm after 50 iterations, as most of a run's are. Swarms are 100 particles on a ring
// for 200 iterations per life; their time is all-in. `plain` is the same work written plainly.
#include <benchmark/benchmark.h>

#include <memory>
#include <string>

#include "algorithms/pso/waypoint_birth.hpp"
#include "algorithms/pso/waypoint_cost.hpp"
#include "bench/executors.hpp"
#include "bench/micro/plain_swarm.hpp"
#include "bench/roster.hpp"
#include "scenarios/library.hpp"

namespace pathrace::bench::micro {
namespace {

using algorithms::Birth;

constexpr std::size_t waypoints = 8;
constexpr std::size_t abreast = algorithms::Swarm::abreast;

Scenario dense() {
  return scenarios::Library().load("dense/20-20/1");
}

enum class Paths { uniform, line, evolved };

using Verdicts = std::vector<algorithms::WaypointVerdict>;

void judge_all(const algorithms::WaypointCost& judge, const algorithms::Swarm& swarm, Verdicts& verdicts) {
  for (std::size_t i = 0; i < swarm.size(); i += abreast) {
    judge.judge(swarm.positions(i, abreast), std::span(verdicts).subspan(i, abreast));
  }
}

algorithms::Swarm paths_of(const Scenario& scenario, Paths paths) {
  algorithms::SwarmSettings settings;
  settings.particles = 1024;
  settings.inertia = algorithms::InertiaRule::constriction;
  settings.c1 = settings.c2 = 2.05;
  settings.topology = algorithms::Topology::ring;
  const Birth birth = paths == Paths::line ? Birth::line : Birth::uniform;
  const algorithms::WaypointNursery nursery(scenario.grid(), scenario.start, scenario.goal, birth, 4);
  algorithms::Swarm swarm(settings, nursery.box(waypoints, 1));
  for (std::size_t i = 0; i < swarm.size(); ++i) nursery.place(swarm, i, Stream(1).fork(i));
  if (paths != Paths::evolved) return swarm;
  const algorithms::WallMap walls(scenario.grid());
  const algorithms::WaypointCost judge(walls, scenario.start, scenario.goal);
  Verdicts verdicts(swarm.size());
  for (std::uint64_t k = 0; k < 50; ++k) {
    judge_all(judge, swarm, verdicts);
    for (std::size_t i = 0; i < swarm.size(); ++i) {
      swarm.judge(i, verdicts[i].length + 40 * verdicts[i].walls);
    }
    swarm.learn(swarm.size());
    for (std::size_t i = 0; i < swarm.size(); i += abreast) {
      swarm.move(i, abreast, algorithms::momentum(settings, k, 50), Stream(2).fork(k));
    }
  }
  return swarm;
}

void cost(benchmark::State& state, Paths kind) {
  const Scenario scenario = dense();
  const algorithms::Swarm swarm = paths_of(scenario, kind);
  const algorithms::WallMap walls(scenario.grid());
  const algorithms::WaypointCost judge(walls, scenario.start, scenario.goal);
  Verdicts verdicts(swarm.size());
  for (auto _ : state) {
    judge_all(judge, swarm, verdicts);
    benchmark::DoNotOptimize(verdicts.data());
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(swarm.size()));
}

void plain_cost(benchmark::State& state, Paths kind) {
  const Scenario scenario = dense();
  const algorithms::Swarm swarm = paths_of(scenario, kind);
  std::vector<std::vector<Point>> paths;
  for (std::size_t i = 0; i < swarm.size(); ++i) {
    std::vector<Point> path{centre(scenario.start)};
    for (std::size_t k = 0; k < waypoints; ++k) {
      path.push_back({swarm.position(i)[k], swarm.position(i)[waypoints + k]});
    }
    path.push_back(centre(scenario.goal));
    paths.push_back(path);
  }
  for (auto _ : state) {
    for (const std::vector<Point>& path : paths) benchmark::DoNotOptimize(plain_judge(scenario.grid(), path));
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(paths.size()));
}

void pso(benchmark::State& state, const std::string& backend) {
  const auto threads = static_cast<int>(state.range(0));
  const Scenario scenario = dense();
  const Entrant entrant = roster().enter(parse_call("pso:waypoints_min=8,waypoints_max=8,birth=uniform"));
  const std::unique_ptr<MapPlanner> planner = entrant.card->make(entrant.values)(scenario.terrain);
  const std::unique_ptr<Executor> executor = make_executor(backend, threads);
  Budget budget;
  budget.evaluations = 201 * 100;
  std::uint64_t evaluations = 0;
  executor->with_team([&] {
    for (auto _ : state) {
      Meter meter(budget);
      Context context{Stream(1), *executor, meter};
      benchmark::DoNotOptimize(planner->plan(scenario.start, scenario.goal, context));
      evaluations += meter.work().evaluations;
    }
  });
  state.SetItemsProcessed(static_cast<std::int64_t>(evaluations));
}

void plain_pso(benchmark::State& state) {
  const Scenario scenario = dense();
  const Problem problem{scenario.grid(), scenario.terrain.rule, scenario.start, scenario.goal};
  for (auto _ : state) {
    PlainSwarm swarm(problem, 100, waypoints, Stream(1));
    for (std::uint64_t k = 1; k <= 200; ++k) swarm.iterate(Stream(1).fork(k));
    benchmark::DoNotOptimize(swarm.best_cost());
  }
  state.SetItemsProcessed(state.iterations() * 201 * 100);
}

BENCHMARK_CAPTURE(plain_cost, uniform, Paths::uniform);
BENCHMARK_CAPTURE(cost, uniform, Paths::uniform);
BENCHMARK_CAPTURE(plain_cost, line, Paths::line);
BENCHMARK_CAPTURE(cost, line, Paths::line);
BENCHMARK_CAPTURE(plain_cost, evolved, Paths::evolved);
BENCHMARK_CAPTURE(cost, evolved, Paths::evolved);
BENCHMARK(plain_pso)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(pso, serial, "serial")->Arg(1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(pso, openmp, "openmp")->Arg(1)->Arg(2)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(pso, tbb, "tbb")->Arg(1)->Arg(2)->UseRealTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pathrace::bench::micro
