// Where OMPL's random numbers come from: the trial's stream.
//
// Every generator that OMPL makes - in planners, samplers, informed samplers, nearest-neighbour trees,
// discretizations - is made by ompl::RNG::RNG(), which draws a seed from one global generator, in the order
// in which the threads of the process happen to ask. Reaching each of them through OMPL's interfaces is not
// possible (many are private). So this program defines that constructor itself, and the dynamic linker
// prefers the program's definition to the library's: a seed then comes from the stream that the running trial
// lent to its thread. The definition stands in the file of `RandomScope`, so that whoever runs a planner
// links it.
#pragma once

#include "core/stream.hpp"

namespace pathrace::baselines {

/// While it lives, generators made by this thread are seeded from its own copy of the stream. Scopes nest.
class RandomScope {
 public:
  explicit RandomScope(const Stream& stream);
  ~RandomScope();
  RandomScope(const RandomScope&) = delete;
  RandomScope& operator=(const RandomScope&) = delete;

 private:
  Stream stream_;
  Stream* outer_;
};

/// Throws Unsupported when libompl seeds its generators by itself, because it is linked statically or with
/// -Bsymbolic: results would then not repeat.
void require_our_seeds();

}  // namespace pathrace::baselines
