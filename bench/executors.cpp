#include "bench/executors.hpp"

#include <fmt/format.h>

#include <array>

#include "bench/thread_probe.hpp"
#include "core/error.hpp"
#include "core/names.hpp"

namespace pathrace::bench {

#define PATHRACE_EXECUTOR(name) std::unique_ptr<Executor> make_##name##_executor(int threads);
#include "bench/executors.def"
#undef PATHRACE_EXECUTOR

namespace {

struct Entry {
  std::string_view name;
  std::unique_ptr<Executor> (*make)(int threads);
};

constexpr auto entries = std::to_array<Entry>({
#define PATHRACE_EXECUTOR(name) {#name, make_##name##_executor},
#include "bench/executors.def"
#undef PATHRACE_EXECUTOR
});

}  // namespace

std::unique_ptr<Executor> make_executor(std::string_view name, int threads) {
  if (threads < 1 || threads > max_threads) {
    throw InputError(fmt::format("threads must be 1 to {}, got {}", max_threads, threads));
  }
  for (const Entry& entry : entries) {
    if (entry.name != name) continue;
    if (name != "serial") require_threads(threads - 1);
    return entry.make(threads);
  }
  throw InputError(unknown_name("backend", name, executor_names()));
}

std::string default_backend() {
  return PATHRACE_BACKEND;
}

std::vector<std::string> executor_names() {
  std::vector<std::string> names;
  for (const Entry& entry : entries) names.emplace_back(entry.name);
  return names;
}

}  // namespace pathrace::bench
