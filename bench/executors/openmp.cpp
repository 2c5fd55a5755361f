// A parallel region per call, chunks dealt out one at a time.
//
// Traps: the runtime's settings (dynamic adjustment, nesting depth) belong to the calling thread and not to
// the process, so they are set before each region. By default only the outermost region gets threads, and
// a planner's loop inside a parallel campaign would silently be serial. A region inside one of the same
// executor would get a second team beside the first, n * n threads for n asked, so it runs inline. Inner
// teams of libgomp are not pooled: each inner region starts its threads anew.
#include <omp.h>

#include <utility>

#include "bench/executors/chunks.hpp"

namespace pathrace::bench {
namespace {

class OpenMpExecutor final : public Executor {
 public:
  explicit OpenMpExecutor(int threads) : threads_(threads) {}

  std::string_view name() const override { return "openmp"; }
  int threads() const override { return threads_; }

 private:
  void run_chunks(std::size_t count, std::size_t grain, ChunkBody body) override {
    Chunks chunks(count, grain, body, census_);
    if (threads_ == 1 || chunks.size() == 1 || innermost == this) return chunks.run_inline();
    omp_set_dynamic(0);  // the number asked for, also above the number of cores
    omp_set_max_active_levels(omp_get_supported_active_levels());
    const std::size_t size = chunks.size();
#pragma omp parallel num_threads(threads_)
    {
      const OpenMpExecutor* const outer = std::exchange(innermost, this);
#pragma omp for schedule(dynamic, 1)
      for (std::size_t k = 0; k < size; ++k) chunks.run(k);
      innermost = outer;
    }
    chunks.rethrow();
  }

  // Whose chunk this thread is running.
  static thread_local const OpenMpExecutor* innermost;

  int threads_;
};

thread_local const OpenMpExecutor* OpenMpExecutor::innermost = nullptr;

}  // namespace

std::unique_ptr<Executor> make_openmp_executor(int threads) {
  return std::make_unique<OpenMpExecutor>(threads);
}

}  // namespace pathrace::bench
