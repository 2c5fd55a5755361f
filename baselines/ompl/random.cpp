#include "baselines/ompl/random.hpp"

#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/util/RandomNumbers.h>

#include <atomic>
#include <cstdint>

#include "core/error.hpp"
#include "core/hash.hpp"

namespace pathrace::baselines {
namespace {

thread_local Stream* current = nullptr;
thread_local std::uint64_t seeds_given = 0;
std::atomic<std::uint64_t> seeds_outside{0};  // to generators that no trial makes

// The library's generators read 32 bits.
std::uint_fast32_t next_seed() {
  ++seeds_given;
  const std::uint64_t bits = current != nullptr ? current->bits() : mix64(seeds_outside.fetch_add(1));
  return bits >> 32;
}

// A sampler of the library makes its generator inside the library.
bool library_asks_us() {
  const ompl::base::RealVectorStateSpace space(2);
  const std::uint64_t before = seeds_given;
  const auto sampler = space.allocDefaultStateSampler();
  return seeds_given != before;
}

}  // namespace

RandomScope::RandomScope(const Stream& stream) : stream_(stream), outer_(current) {
  current = &stream_;
}

RandomScope::~RandomScope() {
  current = outer_;
}

void require_our_seeds() {
  static const bool holds = library_asks_us();
  if (holds) return;
  throw Unsupported(
      "libompl seeds its random numbers by itself, so results would not repeat: link it as a shared library "
      "that was not built with -Bsymbolic, and this code into the program itself");
}

}  // namespace pathrace::baselines

ompl::RNG::RNG() : RNG(pathrace::baselines::next_seed()) {}
