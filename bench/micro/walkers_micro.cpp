// Walkers alone: what it brings to keep several ants on the way; and what their deposits cost.
//
// 50 ants of `as:dead_end=backtrack` per run on the trail of dense/<n>-20/1. An item of `walkers` is a
// decision of an ant, on an even trail; the second argument is the number of lanes: 1 walks one ant at a
// time. An item of `deposits` is a step of a path, which is deposited on both ways.
#include <benchmark/benchmark.h>

#include <cmath>
#include <string>

#include "algorithms/aco/walker.hpp"
#include "scenarios/library.hpp"

namespace pathrace::bench::micro {
namespace {

using algorithms::AntQueue;
using algorithms::DeadEnd;
using algorithms::Ground;
using algorithms::Nest;
using algorithms::Trail;
using algorithms::Walk;
using algorithms::Walker;

struct Field {
  explicit Field(std::int64_t side)
      : scenario(scenarios::Library().load("dense/" + std::to_string(side) + "-20/1")) {
    ground.dead_end = DeadEnd::backtrack;
    ground.max_steps = 20 * nest.free_cells();
  }

  double eta(std::size_t index, int direction) const {
    const Cell cell = nest.cell(nest.moves().step(index, direction));
    return 1 / (0.01 + std::hypot(cell.x - scenario.goal.x, cell.y - scenario.goal.y));
  }

  Scenario scenario;
  Nest nest{{scenario.grid(), scenario.terrain.rule, scenario.start, scenario.goal}};
  Trail trail{nest.moves(), 1, 1, 7,
              [this](std::size_t index, int direction) { return eta(index, direction); }};
  Ground ground{nest, trail};
  std::vector<Walk> walks = std::vector<Walk>(50);
};

void walkers(benchmark::State& state) {
  Field field(state.range(0));
  Walker walker(field.ground, static_cast<std::size_t>(state.range(1)));
  const Meter meter({});
  std::uint64_t iteration = 0;
  std::uint64_t decisions = 0;
  for (auto _ : state) {
    AntQueue ants(0, field.walks.size());
    const Stream stream = Stream(1).fork(iteration++);
    walker.run(ants, {stream, field.ground.max_steps, meter, field.walks});
    for (const Walk& walk : field.walks) decisions += walk.decisions;
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(decisions));
}

void deposits(benchmark::State& state) {
  Field field(state.range(0));
  AntQueue ants(0, field.walks.size());
  const Stream stream(1);
  const Meter meter({});
  Walker(field.ground, 4).run(ants, {stream, field.ground.max_steps, meter, field.walks});
  std::size_t steps = 0;
  for (auto _ : state) {
    field.trail.evaporate(0.9);
    for (const Walk& walk : field.walks) {
      field.trail.change_along(field.nest.start(), walk.directions, 1, 1 / walk.length.value(), true);
      steps += walk.directions.size();
    }
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(steps));
}

BENCHMARK(walkers)->ArgsProduct({{20, 100, 128, 256, 512}, {1, 4, 6, 8, 12}})->Unit(benchmark::kMicrosecond);
BENCHMARK(deposits)->Arg(20)->Arg(128)->Arg(512)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace pathrace::bench::micro
