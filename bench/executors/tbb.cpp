// An arena of its own size per executor. Outside of a team, one task per chunk, stolen by whoever is idle. A
// team's helpers are tasks that last as long as the team: to call a worker for each loop would cost some
// microseconds, and some tens of them once it sleeps. The leader stays outside of the arena, so that what it
// runs stays on its thread even when the arena is full, and waits for nobody who has not come.
//
// Traps: the arena's size asks for workers, the process-wide limit grants them, and that limit starts at
// the number of cores the main thread may run on. With OMP_PROC_BIND, or a main thread pinned before the
// first use, it is one, and every loop is silently serial. Of several tbb::global_control objects the
// LEAST counts, so there is a single one, above what all arenas together ask for. It lifts the limit, but
// workers still inherit the mask of a pinned thread: how many threads really ran is the census's to say,
// on how many cores is not.
//
// A worker may start others, and they would inherit its processors: it goes to its share
// (processor_shares.hpp), but is not kept there.
//
// While it waits for an inner loop, a thread would by default take another chunk of the outer one, on top
// of the one it has not finished; `isolate` keeps it to the inner loop.
#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <memory>

#include "bench/executors.hpp"
#include "bench/executors/team_executor.hpp"

namespace pathrace::bench {
namespace {

void lift_the_limit_on_workers() {
  constexpr std::size_t arenas_at_full_size = 8;
  static const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                         arenas_at_full_size * max_threads);
}

class TbbExecutor final : public TeamExecutor {
 public:
  explicit TbbExecutor(int threads) : TeamExecutor(threads), arena_(threads) {
    lift_the_limit_on_workers();
    start();
  }

  // Helpers that have not come by now come here, to find that everything is over.
  ~TbbExecutor() noexcept override {
    arena_.execute([this] { helpers_.wait(); });
  }

  std::string_view name() const override { return "tbb"; }

 private:
  // A team that stays as long as somebody is still to come.
  struct Gathering : Team, std::enable_shared_from_this<Gathering> {
    explicit Gathering(bool is_outermost) : outermost(is_outermost) {}

    bool outermost;  // else nobody is moved
  };

  void run_apart(Chunks& chunks) override {
    const auto run_range = [&chunks](const tbb::blocked_range<std::size_t>& range) {
      for (std::size_t k = range.begin(); k < range.end(); ++k) TeamExecutor::run_apart(chunks, k);
    };
    const auto loop = [&] {
      // The simple partitioner keeps every chunk on offer to other threads.
      tbb::parallel_for(tbb::blocked_range<std::size_t>(0, chunks.size(), 1), run_range,
                        tbb::simple_partitioner{});
    };
    arena_.execute([&loop] { tbb::this_task_arena::isolate(loop); });
  }

  void gather(const Lead& lead) override {
    const auto gathering = std::make_shared<Gathering>(outermost());
    lead_team(*gathering, lead);
  }

  void call_helpers(Team& team) override {
    auto& gathering = static_cast<Gathering&>(team);
    if (gathering.outermost) shares().go_to(0);
    for (int k = 1; k < threads(); ++k) {
      arena_.enqueue(helpers_.defer([kept = gathering.shared_from_this(), k, this] {
        if (kept->is_dismissed()) return;
        if (kept->outermost) shares().go_to(k);
        arrive();
        serve(*kept);
      }));
    }
  }

  tbb::task_arena arena_;
  tbb::task_group helpers_;  // of all teams
};

}  // namespace

std::unique_ptr<Executor> make_tbb_executor(int threads) {
  return std::make_unique<TbbExecutor>(threads);
}

}  // namespace pathrace::bench
