// An arena of its own size per executor; one task per chunk, stolen by whoever is idle.
//
// Traps: the arena's size asks for workers, the process-wide limit grants them, and that limit starts at
// the number of cores the main thread may run on. With OMP_PROC_BIND, or a main thread pinned before the
// first use, it is one, and every loop is silently serial. Of several tbb::global_control objects the
// LEAST counts, so there is a single one, above what all arenas together ask for. It lifts the limit, but
// workers still inherit the mask of a pinned thread: how many threads really ran is the census's to say,
// on how many cores is not.
//
// While it waits for an inner loop, a thread would by default take another chunk of the outer one, on top
// of the one it has not finished; `isolate` keeps it to the inner loop.
#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>

#include "bench/executors.hpp"
#include "bench/executors/chunks.hpp"

namespace pathrace::bench {
namespace {

void lift_the_limit_on_workers() {
  constexpr std::size_t arenas_at_full_size = 8;
  static const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                         arenas_at_full_size * max_threads);
}

class TbbExecutor final : public Executor {
 public:
  explicit TbbExecutor(int threads) : threads_(threads), arena_(threads) { lift_the_limit_on_workers(); }

  std::string_view name() const override { return "tbb"; }
  int threads() const override { return threads_; }

 private:
  void run_chunks(std::size_t count, std::size_t grain, ChunkBody body) override {
    Chunks chunks(count, grain, body, census_);
    if (threads_ == 1 || chunks.size() == 1) return chunks.run_inline();
    const auto run_range = [&chunks](const tbb::blocked_range<std::size_t>& range) {
      for (std::size_t k = range.begin(); k < range.end(); ++k) chunks.run(k);
    };
    const auto loop = [&] {
      // The simple partitioner keeps every chunk on offer to other threads.
      tbb::parallel_for(tbb::blocked_range<std::size_t>(0, chunks.size(), 1), run_range,
                        tbb::simple_partitioner{});
    };
    arena_.execute([&loop] { tbb::this_task_arena::isolate(loop); });
    chunks.rethrow();
  }

  int threads_;
  tbb::task_arena arena_;
};

}  // namespace

std::unique_ptr<Executor> make_tbb_executor(int threads) {
  return std::make_unique<TbbExecutor>(threads);
}

}  // namespace pathrace::bench
