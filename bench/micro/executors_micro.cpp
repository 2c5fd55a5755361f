// What a loop costs besides its work: two chunks on two threads that meet, each waiting for the other.
//
// A colony runs one loop per iteration; on a 20x20 map an iteration is some thirty microseconds of work.
// `alone` gathers its threads for each loop, `team` once for all, as a trial does.
#include <benchmark/benchmark.h>

#include <array>
#include <atomic>
#include <string>

#include "bench/executors.hpp"

namespace pathrace::bench::micro {
namespace {

struct alignas(64) Flag {
  std::atomic<std::int64_t> round{0};
};

void meet(Executor& executor, std::array<Flag, 2>& flags, std::int64_t round) {
  for_each_index(executor, 2, 1, [&](std::size_t k) {
    flags[k].round.store(round, std::memory_order_release);
    while (flags[1 - k].round.load(std::memory_order_acquire) < round) {
    }
  });
}

void alone(benchmark::State& state, const std::string& backend) {
  const auto executor = make_executor(backend, 2);
  std::array<Flag, 2> flags;
  std::int64_t round = 0;
  for (auto _ : state) meet(*executor, flags, ++round);
}

void team(benchmark::State& state, const std::string& backend) {
  const auto executor = make_executor(backend, 2);
  std::array<Flag, 2> flags;
  std::int64_t round = 0;
  executor->with_team([&] {
    for (auto _ : state) meet(*executor, flags, ++round);
  });
}

BENCHMARK_CAPTURE(alone, openmp, "openmp")->UseRealTime();
BENCHMARK_CAPTURE(alone, tbb, "tbb")->UseRealTime();
BENCHMARK_CAPTURE(team, openmp, "openmp")->UseRealTime();
BENCHMARK_CAPTURE(team, tbb, "tbb")->UseRealTime();
BENCHMARK_CAPTURE(team, threads, "threads")->UseRealTime();

}  // namespace
}  // namespace pathrace::bench::micro
