// A navigator's step: how long the robot thinks, and evaluations per second of a swarm that steers.
//
// One step on the world's first snapshot, over and over; the time is all-in: discs grown and grouped, swarm,
// penalties. An item is an evaluation for nasrollahy2009 (30 particles, 50 iterations after the birth, so
// 1530 of them a step) and a step for the rest. `open` has 10 discs, `dense` 30, all of which each evaluation
// looks at twice.
#include <benchmark/benchmark.h>

#include <memory>
#include <string>

#include "bench/executors.hpp"
#include "bench/roster.hpp"
#include "core/world_motion.hpp"
#include "scenarios/library.hpp"

namespace pathrace::bench::micro {
namespace {

void step(benchmark::State& state, const char* id, const std::string& call, const std::string& backend) {
  const Scenario scenario = scenarios::Library().load(id);
  const World& world = *scenario.world;
  WorldMotion motion(world);
  motion.advance(world.start);
  const Snapshot snapshot{world.width,        world.height,     world.start,
                          world.robot_radius, world.robot_step, motion.goal(),
                          world.arrival,      motion.discs(),   0};
  const Entrant entrant = roster().enter(parse_call(call));
  const std::unique_ptr<Executor> executor = make_executor(backend, static_cast<int>(state.range(0)));
  std::uint64_t evaluations = 0;
  executor->with_team([&] {
    for (auto _ : state) {
      const std::unique_ptr<Navigator> navigator = entrant.card->make_navigator(entrant.values)();
      Meter meter{Budget{}};
      Context context{Stream(1), *executor, meter};
      benchmark::DoNotOptimize(navigator->next(snapshot, context));
      evaluations += meter.work().evaluations;
    }
  });
  const bool swarms = call.starts_with("nasrollahy2009");
  state.SetItemsProcessed(swarms ? static_cast<std::int64_t>(evaluations) : state.iterations());
}

constexpr const char* open = "discs/open/1";
constexpr const char* dense = "discs/dense/1";
constexpr const char* swarm = "nasrollahy2009";

BENCHMARK_CAPTURE(step, nasrollahy_open, open, swarm, "serial")->Arg(1)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(step, nasrollahy_dense, dense, swarm, "serial")->Arg(1)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(step, nasrollahy_dense_openmp, dense, swarm, "openmp")
    ->Arg(1)
    ->Arg(2)
    ->UseRealTime()
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(step, nasrollahy_1000_particles_openmp, dense, "nasrollahy2009:particles=1000", "openmp")
    ->Arg(1)
    ->Arg(2)
    ->UseRealTime()
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(step, replan_astar_dense, dense, "replan(astar)", "serial")
    ->Arg(1)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(step, potential_field_dense, dense, "potential-field", "serial")
    ->Arg(1)
    ->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace pathrace::bench::micro
