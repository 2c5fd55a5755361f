// What a planner allocates does not grow with its ants: memory is asked for when it begins, not while it
// walks. Here every `new` of this process is counted.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "bench/executors.hpp"
#include "bench/roster.hpp"
#include "scenarios/library.hpp"

namespace {

std::atomic<std::uint64_t> allocations{0};

void* counted(std::size_t size, std::size_t alignment) {
  allocations.fetch_add(1, std::memory_order_relaxed);
  const std::size_t rounded = (size + alignment - 1) / alignment * alignment;
  void* const memory = std::aligned_alloc(alignment, rounded);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

}  // namespace

// Forms for arrays end in these; those that do not throw do so in the standard library, but not where a
// sanitizer has its own. Never inline, or g++ sees `free` where it expects `delete`, and warns.
[[gnu::noinline]] void* operator new(std::size_t size) {
  return counted(size, alignof(std::max_align_t));
}
[[gnu::noinline]] void* operator new(std::size_t size, std::align_val_t alignment) {
  return counted(size, static_cast<std::size_t>(alignment));
}
[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t& /*tag*/) noexcept {
  return counted(size, alignof(std::max_align_t));
}
[[gnu::noinline]] void* operator new(std::size_t size, std::align_val_t alignment,
                                     const std::nothrow_t& /*tag*/) noexcept {
  return counted(size, static_cast<std::size_t>(alignment));
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t /*size*/) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::align_val_t /*alignment*/) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t /*size*/,
                                       std::align_val_t /*alignment*/) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, const std::nothrow_t& /*tag*/) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::align_val_t /*alignment*/,
                                       const std::nothrow_t& /*tag*/) noexcept {
  std::free(memory);
}

namespace pathrace::bench {
namespace {

std::uint64_t allocations_of(const std::string& call, std::uint64_t iterations) {
  const Scenario scenario = scenarios::Library().load("dense/20-30/4");
  const Entrant entrant = roster().enter(parse_call(call));
  const auto planner = entrant.card->make(entrant.values)(scenario.terrain);
  Budget budget;
  budget.iterations = iterations;
  const auto executor = make_executor("serial", 1);
  Meter meter(budget);
  Context context{Stream(1), *executor, meter};
  const std::uint64_t before = allocations;
  planner->plan(scenario.start, scenario.goal, context);
  return allocations - before;
}

TEST(Allocations, AreFewInAnIterationOfFiftyAnts) {
  for (const char* call :
       {"as:ants=50", "as:ants=50,dead_end=backtrack", "as:ants=50,dead_end=revisit_with_loop_erasure",
        "eas:ants=50,dead_end=backtrack", "as-rank:ants=50,dead_end=backtrack",
        "mmas:ants=50,dead_end=backtrack", "acs:ants=50,dead_end=backtrack", "tan2016:ants=50",
        "pu2022:ants=50", "xie2010:population=50", "pso:particles=50"}) {
    const std::uint64_t before = allocations_of(call, 100);
    const std::uint64_t after = allocations_of(call, 200);
    EXPECT_LE(after - before, 5 * 100U) << call;
    EXPECT_GT(before, 10U) << "nothing is counted";
  }
}

}  // namespace
}  // namespace pathrace::bench
