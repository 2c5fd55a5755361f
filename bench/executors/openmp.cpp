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

#include <atomic>
#include <chrono>
#include <exception>
#include <thread>
#include <utility>

#include "bench/executors/processor_shares.hpp"
#include "bench/executors/team.hpp"

namespace pathrace::bench {
namespace {

class OpenMpExecutor final : public Executor {
 public:
  explicit OpenMpExecutor(int threads) : threads_(threads), shares_(threads) { gather(); }

  std::string_view name() const override { return "openmp"; }
  int threads() const override { return threads_; }

  void with_team(const std::function<void()>& body) override {
    if (threads_ == 1 || works() || leads()) return body();
    open_region([&body](Team&) { body(); });
  }

 private:
  // What the calling thread is to which executor.
  struct Role {
    const OpenMpExecutor* executor = nullptr;
    Team* led = nullptr;  // null for who runs a chunk
  };

  bool works() const { return role.executor == this && role.led == nullptr; }
  bool leads() const { return role.executor == this && role.led != nullptr; }

  void run_chunks(std::size_t count, std::size_t grain, ChunkBody body) override {
    Chunks chunks(count, grain, body, census_);
    if (threads_ == 1 || chunks.size() == 1 || works()) return chunks.run_inline();
    const auto run = [&](Team& team) {
      const Role before = std::exchange(role, Role{this, nullptr});
      team.run(chunks);
      role = before;
    };
    leads() ? run(*role.led) : open_region(run);
    chunks.rethrow();
  }

  // Starts the threads of the calling thread's outermost regions, and lets each of them find its share: the
  // first trial is not to wait for that.
  void gather() {
    using namespace std::chrono_literals;
    if (threads_ == 1 || !shares_.exist() || omp_get_level() > 0) return;
    open_region([this](Team&) {
      constexpr int patience = 1000;
      for (int k = 0; k < patience && settled_ < threads_ - 1; ++k) std::this_thread::sleep_for(20us);
    });
  }

  // A helper's, of an outermost region.
  void settle(int k) {
    static thread_local std::pair<int, int> share;  // threads, and which of them it settled as last
    const std::pair<int, int> due{threads_, k};
    if (std::exchange(share, due) != due) shares_.settle(k);
    ++settled_;
  }

  // Calls lead(team) on this thread while the others of the region serve.
  template <typename Lead>
  void open_region(const Lead& lead) {
    omp_set_dynamic(0);  // the number asked for, also above the number of cores
    omp_set_max_active_levels(omp_get_supported_active_levels());
    const bool outermost = omp_get_level() == 0;
    if (outermost) shares_.go_to(0);
    Team team;
    std::exception_ptr failure;  // must not leave the region
#pragma omp parallel num_threads(threads_)
    {
      const bool leader = omp_get_thread_num() == 0;
      const Role before = std::exchange(role, Role{this, leader ? &team : nullptr});
      if (leader) {
        try {
          lead(team);
        } catch (...) {
          failure = std::current_exception();
        }
        team.dismiss();
      } else {
        if (outermost) settle(omp_get_thread_num());
        team.serve();
      }
      role = before;
    }
    if (failure) std::rethrow_exception(failure);
  }

  static thread_local Role role;

  int threads_;
  ProcessorShares shares_;
  std::atomic<int> settled_{0};
};

thread_local OpenMpExecutor::Role OpenMpExecutor::role;

}  // namespace

std::unique_ptr<Executor> make_openmp_executor(int threads) {
  return std::make_unique<OpenMpExecutor>(threads);
}

}  // namespace pathrace::bench
