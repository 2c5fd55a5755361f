// Walkers alone: what it brings to keep several ants on the way.
//
// An item is a decision of an ant; 50 ants of `as:dead_end=backtrack` per run on an even trail of
// dense/<n>-20/1, without deposits. The second argument is the number of lanes: 1 walks one ant at a time.
#include <benchmark/benchmark.h>

#include <cmath>
#include <string>

#include "algorithms/aco/walker.hpp"
#include "scenarios/library.hpp"

namespace pathrace::bench::micro {
namespace {

using namespace algorithms;

void walkers(benchmark::State& state) {
  const Scenario scenario = scenarios::Library().load("dense/" + std::to_string(state.range(0)) + "-20/1");
  const Nest nest({scenario.grid(), scenario.terrain.rule, scenario.start, scenario.goal});
  const Trail trail(nest.moves(), 1, 1, 7, [&](std::size_t index, int direction) {
    const Cell cell = nest.cell(nest.moves().step(index, direction));
    return 1 / (0.01 + std::hypot(cell.x - scenario.goal.x, cell.y - scenario.goal.y));
  });
  Ground ground{nest, trail};
  ground.dead_end = DeadEnd::backtrack;
  ground.max_steps = 20 * nest.free_cells();
  Walker walker(ground, static_cast<std::size_t>(state.range(1)));
  std::vector<Walk> walks(50);
  const Meter meter({});
  std::uint64_t iteration = 0;
  std::uint64_t decisions = 0;
  for (auto _ : state) {
    AntQueue ants(0, walks.size());
    walker.run(ants, Stream(1).fork(iteration++), ground.max_steps, meter, walks);
    for (const Walk& walk : walks) decisions += walk.decisions;
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(decisions));
}

BENCHMARK(walkers)->ArgsProduct({{20, 100, 128, 256, 512}, {1, 4, 6, 8, 12}})->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace pathrace::bench::micro
