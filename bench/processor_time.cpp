#include "bench/processor_time.hpp"

#include <sys/resource.h>

#include <algorithm>

namespace pathrace::bench {
namespace {

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

ProcessorTime used_by(decltype(RUSAGE_SELF) who) {
  rusage usage{};
  ::getrusage(who, &usage);
  return {seconds(usage.ru_utime), seconds(usage.ru_stime)};
}

}  // namespace

ProcessorTime thread_time() {
  return used_by(RUSAGE_THREAD);
}

ProcessorTime process_time() {
  return used_by(RUSAGE_SELF);
}

bool disturbed(double wall_s, const ProcessorTime& used) {
  constexpr double least_s = 0.01;
  constexpr double share = 0.2;
  return wall_s - used.total_s() > std::max(least_s, share * wall_s);
}

}  // namespace pathrace::bench
