// One parallel region for a planner's whole call, or for a loop outside of one; its threads form a team.
//
// Traps: the runtime's settings (dynamic adjustment, nesting depth) belong to the calling thread and not to
// the process, so they are set before each region. By default only the outermost region gets threads, and
// a planner's loop inside a parallel campaign would silently be serial. A region inside one of the same
// executor would get a second team beside the first, n * n threads for n asked, so it runs inline. Inner
// teams of libgomp are not pooled: each inner region starts its threads anew.
//
// Threads of outermost regions are kept apart (processor_shares.hpp): the others stay on shares of their own,
// and who opens a region gets out of their way.
#include <omp.h>

#include <exception>
#include <utility>

#include "bench/executors/team_executor.hpp"

namespace pathrace::bench {
namespace {

class OpenMpExecutor final : public TeamExecutor {
 public:
  explicit OpenMpExecutor(int threads) : TeamExecutor(threads) { start(); }

  std::string_view name() const override { return "openmp"; }

 private:
  void run_apart(Chunks& chunks) override {
    gather([this, &chunks](Team& team) { run_in(team, chunks); });
  }

  // A helper's, of an outermost region.
  void settle(int k) {
    static thread_local std::pair<int, int> share;  // threads, and which of them it settled as last
    const std::pair<int, int> due{threads(), k};
    if (std::exchange(share, due) != due) shares().settle(k);
    arrive();
  }

  void gather(const Lead& lead) override {
    omp_set_dynamic(0);  // the number asked for, also above the number of cores
    omp_set_max_active_levels(omp_get_supported_active_levels());
    const bool may_settle = outermost();
    if (may_settle) shares().go_to(0);
    Team team;
    std::exception_ptr failure;  // must not leave the region
#pragma omp parallel num_threads(threads())
    {
      if (omp_get_thread_num() == 0) {
        try {
          lead_team(team, lead);
        } catch (...) {
          failure = std::current_exception();
        }
      } else {
        if (may_settle) settle(omp_get_thread_num());
        serve(team);
      }
    }
    if (failure) std::rethrow_exception(failure);
  }
};

}  // namespace

std::unique_ptr<Executor> make_openmp_executor(int threads) {
  return std::make_unique<OpenMpExecutor>(threads);
}

}  // namespace pathrace::bench
