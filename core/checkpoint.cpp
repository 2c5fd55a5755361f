#include "core/checkpoint.hpp"

#include "core/meter.hpp"

namespace pathrace {
namespace {

thread_local const Meter* trial = nullptr;

}  // namespace

void checkpoint() {
  if (stop_requested.load(std::memory_order_relaxed)) throw Interrupted();
  if (trial != nullptr && trial->out_of_time()) throw OutOfTime();
}

TrialScope::TrialScope(const Meter& meter) : outer_(trial) {
  trial = &meter;
}

TrialScope::~TrialScope() {
  trial = outer_;
}

}  // namespace pathrace
