#include "bench/executors/chunks.hpp"

#include "bench/float_environment.hpp"

namespace pathrace::bench {

void Chunks::run_body(std::size_t k) {
  const std::size_t begin = k * grain_;
  const std::size_t end = count_ - begin < grain_ ? count_ : begin + grain_;
  census_.note();
  const DefaultFloatsInChunk floats;
  body_(begin, end);
}

void Chunks::run_inline() {
  for (std::size_t k = 0; k < size(); ++k) run_body(k);
}

void Chunks::run(std::size_t k) noexcept {
  if (k > failed_.load(std::memory_order_relaxed)) return;
  try {
    run_body(k);
  } catch (...) {
    const std::scoped_lock lock(mutex_);
    if (k < failed_.load(std::memory_order_relaxed)) {
      failed_.store(k, std::memory_order_relaxed);
      failure_ = std::current_exception();
    }
  }
}

void Chunks::rethrow() const {
  if (failure_) std::rethrow_exception(failure_);
}

}  // namespace pathrace::bench
