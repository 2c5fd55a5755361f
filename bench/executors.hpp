// The executors by name. One executor = one file in bench/executors/ and one line in executors.def.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/executor.hpp"

namespace pathrace::bench {

inline constexpr int max_threads = 256;

/// An executor that may use `threads` threads, the caller included; more threads than cores are not an
/// error, and are not reduced. Throws InputError for an unknown name or for threads outside
/// 1..max_threads; EnvironmentError when the system refuses to start them at the same time
/// (thread_probe.hpp).
std::unique_ptr<Executor> make_executor(std::string_view name, int threads);

/// What runs when nobody chooses: "tbb", unless the build says otherwise (PATHRACE_BACKEND).
std::string default_backend();

/// In the order of executors.def.
std::vector<std::string> executor_names();

}  // namespace pathrace::bench
