// The cost of a parallel region with nothing to do: two chunks on two threads.
//
// A colony enters one per iteration; on a 20x20 map an iteration is some thirty microseconds of work.
// OpenMP's team meets at a barrier, so its figure is the whole cost. With `tbb` and `threads` the caller has
// mostly run both chunks before another thread wakes: their figure is what offering the work costs, not what
// sharing does.
#include <benchmark/benchmark.h>

#include <string>

#include "bench/executors.hpp"

namespace pathrace::bench::micro {
namespace {

void region(benchmark::State& state, const std::string& backend) {
  const auto executor = make_executor(backend, 2);
  for (auto _ : state) {
    executor->run(2, 1, [](std::size_t begin, std::size_t /*end*/) { benchmark::DoNotOptimize(begin); });
  }
}

BENCHMARK_CAPTURE(region, openmp, "openmp")->UseRealTime();
BENCHMARK_CAPTURE(region, tbb, "tbb")->UseRealTime();
BENCHMARK_CAPTURE(region, threads, "threads")->UseRealTime();

}  // namespace
}  // namespace pathrace::bench::micro
