#include "bench/stop.hpp"

#include <csignal>

#include "core/checkpoint.hpp"

namespace pathrace::bench {
namespace {

void request_stop(int) {
  stop_requested.store(true);
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

}  // namespace

void stop_on_signals() {
  std::signal(SIGINT, request_stop);
  std::signal(SIGTERM, request_stop);
}

}  // namespace pathrace::bench
