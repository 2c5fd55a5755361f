// Generating maps of 1024 x 1024 cells, one benchmark per family, without the search that certifies them.
//
// The time is that of loading the scenario less that of proving its optimum once more. Families whose ends
// lie far apart search for them, too; they are generated with their ends in the corners.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <string>

#include "scenarios/family.hpp"
#include "scenarios/library.hpp"

namespace pathrace::bench::micro {
namespace {

using Clock = std::chrono::steady_clock;

double seconds(Clock::duration duration) {
  return std::chrono::duration<double>(duration).count();
}

// "maze/64-2/1" -> "maze/1024-2,ends=corners/"; traps place their own ends.
std::string large_id(const scenarios::Family& family) {
  const std::string& listed = family.library.back();
  const std::size_t size = listed.find('/') + 1;
  const std::size_t end = listed.find_first_of("-/", size);
  const std::string main = listed.substr(end, listed.rfind('/') - end);
  const bool own_ends = family.name.starts_with("trap-") || family.name == "dense";
  return listed.substr(0, size) + "1024" + main + (own_ends ? "" : ",ends=corners") + "/";
}

void generate(benchmark::State& state, const std::string& id) {
  const scenarios::Library library;
  int seed = 0;
  for (auto _ : state) {
    const Clock::time_point begin = Clock::now();
    Scenario scenario = library.load(id + std::to_string(++seed));
    const Clock::time_point loaded = Clock::now();
    scenario.optimum = {};
    scenarios::prove(scenario);
    const Clock::duration search = Clock::now() - loaded;
    state.SetIterationTime(std::max(1e-9, seconds(loaded - begin) - seconds(search)));
  }
}

const bool registered = [] {
  for (const scenarios::Family& family : scenarios::families()) {
    if (family.parameters.empty() || family.dynamic) continue;  // single maps, and worlds without an optimum
    const std::string id = large_id(family);
    benchmark::RegisterBenchmark(("generate/" + family.name).c_str(),
                                 [id](benchmark::State& state) { generate(state, id); })
        ->UseManualTime()
        ->Iterations(5)
        ->Unit(benchmark::kMillisecond);
  }
  return true;
}();

}  // namespace
}  // namespace pathrace::bench::micro
