// pthread_create as on a machine that grants PATHRACE_LIVE_THREADS threads beside the main one at a time. To
// be preloaded: limits on processes do not hold for root.
#include <dlfcn.h>
#include <pthread.h>

#include <atomic>
#include <cerrno>
#include <cstdlib>

namespace {

using Body = void* (*)(void*);
using Create = int (*)(pthread_t*, const pthread_attr_t*, Body, void*);

std::atomic<int> live{0};

struct Start {
  Body body;
  void* argument;
};

void* run(void* given) {
  const Start start = *static_cast<Start*>(given);
  delete static_cast<Start*>(given);
  void* const result = start.body(start.argument);
  --live;
  return result;
}

}  // namespace

extern "C" int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, Body body,
                              void* argument) {
  static const auto real = reinterpret_cast<Create>(::dlsym(RTLD_NEXT, "pthread_create"));
  const char* const limit = std::getenv("PATHRACE_LIVE_THREADS");
  if (limit != nullptr && live.fetch_add(1) >= std::atoi(limit)) {
    --live;
    return EAGAIN;
  }
  auto* const start = new Start{body, argument};
  const int error = real(thread, attributes, run, start);
  if (error != 0) {
    delete start;
    --live;
  }
  return error;
}
