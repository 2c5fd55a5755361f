#include "bench/thread_probe.hpp"

#include <fmt/format.h>

#include <latch>
#include <system_error>
#include <thread>
#include <vector>

#include "core/error.hpp"

namespace pathrace::bench {

void require_threads(int count) {
  std::latch asked(1);
  std::vector<std::jthread> threads;
  try {
    for (int i = 0; i < count; ++i) threads.emplace_back([&asked] { asked.wait(); });
  } catch (const std::system_error& error) {
    asked.count_down();
    throw EnvironmentError(fmt::format("the system refuses thread {} of {} that are needed ({})",
                                       threads.size() + 1, count, error.code().message()));
  }
  asked.count_down();
}

}  // namespace pathrace::bench
